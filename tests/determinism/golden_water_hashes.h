/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0xf3375c1e419cc977, 0xecaf68efd507db1e}}, /* beach */
{0, 1, 17, {0x22557650a7707914, 0xfe769948f135a155}}, /* beach */
{0, 17, 1, {0x819fc0f651c0bf58, 0xdf9a0b612380c864}}, /* beach */
{0, 16, 7, {0xdff2f19c0f5a24a8, 0x5d70b27066b8b9e1}}, /* beach */
{0, 2, 16, {0x788d594e30035e23, 0xcfb40909cdf69358}}, /* beach */
{1, 13, 9, {0x2f60b716057551d9, 0xe6712e1392e98aca}}, /* dam */
{1, 1, 17, {0xe8a2b0f406a37377, 0x26d92085c6a9835f}}, /* dam */
{1, 17, 1, {0x0fae0f5ae9a83a62, 0x2c33cee196d352aa}}, /* dam */
{1, 16, 7, {0x9e0b2a164b5919bc, 0x16ab805fded1515c}}, /* dam */
{1, 2, 16, {0x2c6ddc7ed508dd94, 0xfba3ddd31fc445b0}}, /* dam */
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
{4, 13, 9, {0xa90d7a6457bc73a7, 0xbb32cac3e5241fa2}}, /* coupled, advected */
{4, 1, 17, {0x22cf3b67d77845f6, 0x604d3d2b91ec3698}}, /* coupled, advected */
{4, 17, 1, {0x50345479e401964b, 0xd3f3c40ddb2e2614}}, /* coupled, advected */
{4, 16, 7, {0x27788d85e516d4a9, 0x325415bb54f4adc6}}, /* coupled, advected */
{4, 2, 16, {0xa1732d006f9f4d52, 0xe71d51c7c21da7c9}}, /* coupled, advected */
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
{8, 13, 9, {0x5508ff805bfa46ab, 0x2af33a4bc639a9b8}}, /* river */
{8, 1, 17, {0x271678daea4b8910, 0x49f9922e74d13b3c}}, /* river */
{8, 17, 1, {0xf381e19295ed93c8, 0x68ca373b66a12d01}}, /* river */
{8, 16, 7, {0xf77f2c936501e803, 0xe321e16314f353f2}}, /* river */
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
{11, 13, 9, {0x83f7d54708941936, 0xecd65de27847cef7}}, /* fed */
{11, 1, 17, {0x8c27bb51acc2f15e, 0xf31f218ba57affcb}}, /* fed */
{11, 17, 1, {0x65a893a125244b0a, 0xe40899dae38d9d0b}}, /* fed */
{11, 16, 7, {0x79f26e7bcd91fd2d, 0xf942c60cef9bea4e}}, /* fed */
{11, 2, 16, {0x157e36c8c760a9ad, 0xb9fd126bb8801c35}}, /* fed */
{12, 13, 9, {0xe498d4be2d9256f3, 0x7aa6fe80a2af1653}}, /* everything */
{12, 1, 17, {0x9c50f54440557269, 0xfeda4329d94b5569}}, /* everything */
{12, 17, 1, {0x22897bd677237212, 0x5bffc639c816e8eb}}, /* everything */
{12, 16, 7, {0x7a1093c547e773a4, 0x11f64e49795dc4c7}}, /* everything */
{12, 2, 16, {0x91b5b2aaaefa637a, 0x7dd06bbb988d2f00}}, /* everything */
{13, 13, 9, {0xfb67f2feb6cc6177, 0xc0fe51baa301df25}}, /* everything, large steps */
{13, 1, 17, {0xca67a8bbe7fdc9ec, 0x58f511f7dcfa569a}}, /* everything, large steps */
{13, 17, 1, {0x7ffa921700bce2d4, 0x2ee15cf27baac901}}, /* everything, large steps */
{13, 16, 7, {0x9e2b1d2f9128e7d9, 0xd73927d9043c608f}}, /* everything, large steps */
{13, 2, 16, {0x3600aaa2ac8350c7, 0xf102114941e27f18}}, /* everything, large steps */
{14, 13, 9, {0xa3aba11d7ac82023, 0x52a4a958013456e1}}, /* everything, coupled */
{14, 1, 17, {0x4d7396dc4243b54b, 0x4dd3363c73346a09}}, /* everything, coupled */
{14, 17, 1, {0x1b82ae4820afdbfa, 0xc81dfe26f0221f0d}}, /* everything, coupled */
{14, 16, 7, {0xa0cadc14518e751a, 0x44707852d38ff46c}}, /* everything, coupled */
{14, 2, 16, {0x0e7ec880fe209184, 0x9b0e942b7e6ada56}}, /* everything, coupled */
