/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0xf3375c1e419cc977, 0xecaf68efd507db1e}}, /* beach */
{0, 1, 17, {0x22557650a7707914, 0xfe769948f135a155}}, /* beach */
{0, 17, 1, {0x819fc0f651c0bf58, 0xdf9a0b612380c864}}, /* beach */
{0, 16, 7, {0xdff2f19c0f5a24a8, 0x5d70b27066b8b9e1}}, /* beach */
{0, 2, 16, {0x788d594e30035e23, 0xcfb40909cdf69358}}, /* beach */
{1, 13, 9, {0xd2948075b6d5929a, 0xff2d377bc89ccd9d}}, /* dam */
{1, 1, 17, {0xe8a2b0f406a37377, 0x26d92085c6a9835f}}, /* dam */
{1, 17, 1, {0x0fae0f5ae9a83a62, 0x2c33cee196d352aa}}, /* dam */
{1, 16, 7, {0x9e0b2a164b5919bc, 0x16ab805fded1515c}}, /* dam */
{1, 2, 16, {0x5fd21c66f085c89f, 0x6818530f8d88921d}}, /* dam */
{2, 13, 9, {0x745e4e06bb91b0c4, 0x18a11fd78b9d68e9}}, /* flood */
{2, 1, 17, {0x264f16f6d063701a, 0xb95912c5c5a90fca}}, /* flood */
{2, 17, 1, {0x87b4919cf43297c8, 0x853f51fbbd6e7292}}, /* flood */
{2, 16, 7, {0x06809cf470854840, 0xa60e986fd4c0050d}}, /* flood */
{2, 2, 16, {0x2166d4c5f3f61d8e, 0xc38d0cd6ab4cd8a4}}, /* flood */
{3, 13, 9, {0xcf48022d6b242c7e, 0x395131946d69c07c}}, /* coupled */
{3, 1, 17, {0x798fd8e226aad56b, 0xc6dd9580dc9197a4}}, /* coupled */
{3, 17, 1, {0xef3c3038eb832b5e, 0xaaf8fde7f3d4d58d}}, /* coupled */
{3, 16, 7, {0xa502b34c92d29c47, 0x2fa1c0486c013c0e}}, /* coupled */
{3, 2, 16, {0xe3d121c5db9e2f78, 0x2df5e8991d5cbdbf}}, /* coupled */
{4, 13, 9, {0xe108626cbb58d9d6, 0xafbd17d3cf2411c2}}, /* coupled, advected */
{4, 1, 17, {0x22cf3b67d77845f6, 0x604d3d2b91ec3698}}, /* coupled, advected */
{4, 17, 1, {0x50345479e401964b, 0xd3f3c40ddb2e2614}}, /* coupled, advected */
{4, 16, 7, {0x7fcd0bba69d11e15, 0x0cd717addfcd8abe}}, /* coupled, advected */
{4, 2, 16, {0xa1732d006f9f4d52, 0x02a2c95ff2a739fa}}, /* coupled, advected */
{5, 13, 9, {0x0c97e3c8228d97f5, 0xe91b93c4d4493db1}}, /* explicit */
{5, 1, 17, {0x018954743d60efd2, 0x6c5984d1366f012a}}, /* explicit */
{5, 17, 1, {0x56253404bae5c313, 0xe460c2ba9b07f73e}}, /* explicit */
{5, 16, 7, {0xcfe3845138b47bbe, 0x7e6f9e456a729df6}}, /* explicit */
{5, 2, 16, {0x2fc2fd2ebe07d812, 0xb3c413b0e00f2f68}}, /* explicit */
{6, 13, 9, {0x3a5f0b72d0df4d61, 0x668f650ddc9c5a16}}, /* forward */
{6, 1, 17, {0x73e0263b0c300a01, 0x875173af29e73e97}}, /* forward */
{6, 17, 1, {0x0cc6a528235d039d, 0x41bf44197de7885e}}, /* forward */
{6, 16, 7, {0x1aabafa5d7a91b9f, 0x89051dceaa9ec6ac}}, /* forward */
{6, 2, 16, {0x356441ec03349452, 0x66af0de1f9fb2791}}, /* forward */
{7, 13, 9, {0x392bc4b4b1918e90, 0x89a2e2a65b361914}}, /* tide */
{7, 1, 17, {0x4701924f40b9686e, 0x8dbab2d48b87d419}}, /* tide */
{7, 17, 1, {0x83b24cc488f0315f, 0x4ccddb7d1682de96}}, /* tide */
{7, 16, 7, {0x21ebc1637e8b7a1d, 0x03624022e635de9b}}, /* tide */
{7, 2, 16, {0x4332e75f28b3157e, 0x7b6f03fc224e0d14}}, /* tide */
{8, 13, 9, {0x2298288e104a308b, 0x25184789d4d0d6bc}}, /* river */
{8, 1, 17, {0x271678daea4b8910, 0x49f9922e74d13b3c}}, /* river */
{8, 17, 1, {0xf6e3ec38f16a76b9, 0xb385cd0d8d9d7c99}}, /* river */
{8, 16, 7, {0x2a0961d6ce58b67c, 0x5ab875c72e659117}}, /* river */
{8, 2, 16, {0x7ffd27e108c3b14e, 0x33dbe7502c38851f}}, /* river */
{9, 13, 9, {0x644e289ae36b86d4, 0x5c45fa80fc7c2b41}}, /* torus */
{9, 1, 17, {0x3e2bd7cd1976a460, 0x0a55d8e1e5d8382f}}, /* torus */
{9, 17, 1, {0x8a31d22521c236a7, 0xaf981787110e622b}}, /* torus */
{9, 16, 7, {0xe496bb4cae2a0c36, 0xe9eac246ed39a7c0}}, /* torus */
{9, 2, 16, {0x82adb15e554953fa, 0x9396cbb36fa959cf}}, /* torus */
{10, 13, 9, {0xb6e6177c588e531c, 0x843209a718f4a6e5}}, /* masked */
{10, 1, 17, {0x540906991129215b, 0xc9b2170ccf5b1cbd}}, /* masked */
{10, 17, 1, {0xd1930fc623f587a6, 0xcf9e66c1fe8c4e5f}}, /* masked */
{10, 16, 7, {0x491111b039041114, 0xda17f633f67ad0d4}}, /* masked */
{10, 2, 16, {0x52fa19c63663f7ff, 0x9566f445eb183522}}, /* masked */
{11, 13, 9, {0x333e0a4a32ad7f71, 0xbad5bcc87eed6f18}}, /* fed */
{11, 1, 17, {0x8c27bb51acc2f15e, 0xf31f218ba57affcb}}, /* fed */
{11, 17, 1, {0xc6b2d9701a3341e0, 0xe40899dae38d9d0b}}, /* fed */
{11, 16, 7, {0xee0970dc06681efb, 0xf835e9ead9898bc1}}, /* fed */
{11, 2, 16, {0xf06e78b5f10726ff, 0x0e2a86146326657c}}, /* fed */
{12, 13, 9, {0x985b99a465a4871f, 0xf66285f5f3babab0}}, /* everything */
{12, 1, 17, {0x9c50f54440557269, 0xfeda4329d94b5569}}, /* everything */
{12, 17, 1, {0x960bd298a74992e2, 0x3c37946aadd27fd9}}, /* everything */
{12, 16, 7, {0x5b4bb55afb2c1427, 0x85bb07eb395fc049}}, /* everything */
{12, 2, 16, {0xbe98501deacd83d4, 0x786726722ea1d324}}, /* everything */
{13, 13, 9, {0x64cc545d0d2b35af, 0x9282f906bb31c1d5}}, /* everything, large steps */
{13, 1, 17, {0xf3334b807475432f, 0x60678702380e1f68}}, /* everything, large steps */
{13, 17, 1, {0x7ffa921700bce2d4, 0x2ee15cf27baac901}}, /* everything, large steps */
{13, 16, 7, {0xc745e63620b7ebfa, 0xaf704208f7967707}}, /* everything, large steps */
{13, 2, 16, {0xed5a7f3a66f9e646, 0x0c2a949400161ccd}}, /* everything, large steps */
{14, 13, 9, {0x88fc54641449c13e, 0x710b160779210ca0}}, /* everything, coupled */
{14, 1, 17, {0x4d7396dc4243b54b, 0x4dd3363c73346a09}}, /* everything, coupled */
{14, 17, 1, {0x31a3de2ee092f7e6, 0x30c1661adc756d5f}}, /* everything, coupled */
{14, 16, 7, {0x78a15ea5fc4bc4a6, 0x9e74a887ae3e05b0}}, /* everything, coupled */
{14, 2, 16, {0xbac0afbe8f529be4, 0x8d4d3159ed87969f}}, /* everything, coupled */
