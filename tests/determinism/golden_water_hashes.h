/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0xf8857b11e89d2b15, 0x7820ec6ab082bedd}}, /* beach */
{0, 1, 17, {0xaae71d8a3356e11e, 0x3722ec198108f678}}, /* beach */
{0, 17, 1, {0x0e39abe19b7879f3, 0xa47d51adb49fee25}}, /* beach */
{0, 16, 7, {0x75a0dc56fe938c3b, 0xb76886e36d130757}}, /* beach */
{0, 2, 16, {0x3c869512f5872370, 0xbe688ad6d6b416b0}}, /* beach */
{1, 13, 9, {0x114578e3b569c2d7, 0xb9feed4535fe83ea}}, /* dam */
{1, 1, 17, {0xf3af0fadff5d5608, 0x8ab39f4e43595b19}}, /* dam */
{1, 17, 1, {0xefbc6f9d00c57d84, 0x09fcf2e29187a1af}}, /* dam */
{1, 16, 7, {0x8a830f9b070d14ea, 0x7e6bdc3d9c2b62f1}}, /* dam */
{1, 2, 16, {0xc0ba74b088b722cb, 0x0b147a81794bd899}}, /* dam */
{2, 13, 9, {0x635586da4311fde1, 0x9e0252a0831e982f}}, /* flood */
{2, 1, 17, {0x2acf59162112da3d, 0x43358805765b18d7}}, /* flood */
{2, 17, 1, {0x87b4919cf43297c8, 0x853f51fbbd6e7292}}, /* flood */
{2, 16, 7, {0xdc2b2a27b360bc8d, 0x4803c6fe3c75e124}}, /* flood */
{2, 2, 16, {0x085126fe4e4967ec, 0x90ecdc9349289c4d}}, /* flood */
{3, 13, 9, {0x267cf267e9224123, 0x1c8eb6a00154717c}}, /* coupled */
{3, 1, 17, {0x5c58421e823a19ab, 0xd0f14b4e62a891c5}}, /* coupled */
{3, 17, 1, {0x9a5ed2bcd33c8aaa, 0xdafee58e42d3fdfd}}, /* coupled */
{3, 16, 7, {0xb597e54e697f151a, 0xdf0c1de4ed194f97}}, /* coupled */
{3, 2, 16, {0x75e6c95d6a179f6e, 0x052d23f8966549a5}}, /* coupled */
{4, 13, 9, {0xed7535631a80cf7c, 0x52107c2802a021d3}}, /* coupled, advected */
{4, 1, 17, {0x64e9f27b6574a990, 0x2e32ac147fec7eaf}}, /* coupled, advected */
{4, 17, 1, {0x2808b6237ffcfc49, 0x76f1099299ea3fb8}}, /* coupled, advected */
{4, 16, 7, {0x7fbbeada43e12d17, 0xb358f670510c0c46}}, /* coupled, advected */
{4, 2, 16, {0x9b688d5f36e7a019, 0x4856d950a583d8e0}}, /* coupled, advected */
{5, 13, 9, {0xbab4e62306c5f358, 0x80c3ef997b8ec468}}, /* explicit */
{5, 1, 17, {0x9f7b5526b245474e, 0x00ca7bcf66f4ac98}}, /* explicit */
{5, 17, 1, {0x98d61892e11fdac6, 0x239501211c808804}}, /* explicit */
{5, 16, 7, {0xb9b9640e9436eedb, 0xc427b910646f13ac}}, /* explicit */
{5, 2, 16, {0xa5e5305d98062da4, 0xa85e42e7a8d2cd4f}}, /* explicit */
{6, 13, 9, {0x35bf0059b3db77b1, 0x7b2a5e2cb981b972}}, /* forward */
{6, 1, 17, {0x6b9ed68bc83dda7b, 0xb834c23b6304cfa7}}, /* forward */
{6, 17, 1, {0xc1f0dc0f0b8a006d, 0x9852970dc04e34a3}}, /* forward */
{6, 16, 7, {0x990590820a1d102e, 0xc25ccb156a01b079}}, /* forward */
{6, 2, 16, {0xa698f90a88ab98fd, 0x6e1245d680165b2c}}, /* forward */
{7, 13, 9, {0xa8a1d2e3d5a78dff, 0x42c520ae559410c8}}, /* tide */
{7, 1, 17, {0xd1af62a482527ccc, 0xc20c8667f3c4ad13}}, /* tide */
{7, 17, 1, {0x1a9b16aac865888c, 0xb4972d8b8a1349c0}}, /* tide */
{7, 16, 7, {0x0d2effc78c721d1b, 0xaf187be63ca4fd81}}, /* tide */
{7, 2, 16, {0xdf4466f15705aed6, 0x20312ddcdcdea51a}}, /* tide */
{8, 13, 9, {0xf14d7931f1826f2a, 0xc115f0af5604c5ca}}, /* river */
{8, 1, 17, {0x271678daea4b8910, 0x49f9922e74d13b3c}}, /* river */
{8, 17, 1, {0x0be3220802035d73, 0x526cb7bb9594a024}}, /* river */
{8, 16, 7, {0x6b97d569d17b6605, 0x6e5364a085d7d688}}, /* river */
{8, 2, 16, {0x0874f8c690653cd5, 0x643f42056bd64635}}, /* river */
{9, 13, 9, {0x644e289ae36b86d4, 0x5c45fa80fc7c2b41}}, /* torus */
{9, 1, 17, {0x3e2bd7cd1976a460, 0x0a55d8e1e5d8382f}}, /* torus */
{9, 17, 1, {0x8a31d22521c236a7, 0xaf981787110e622b}}, /* torus */
{9, 16, 7, {0xe496bb4cae2a0c36, 0xe9eac246ed39a7c0}}, /* torus */
{9, 2, 16, {0x82adb15e554953fa, 0x9396cbb36fa959cf}}, /* torus */
{10, 13, 9, {0xe5d21c98a022ef1c, 0x4daa5aecc13d063c}}, /* masked */
{10, 1, 17, {0x26a46ed2f397dd15, 0x57084d37e8d3e142}}, /* masked */
{10, 17, 1, {0xd881b9560130f03c, 0x1693974dc8270617}}, /* masked */
{10, 16, 7, {0x740f2adf9bc7762f, 0xaed886a2f3662036}}, /* masked */
{10, 2, 16, {0xaa239e0f5c68bc3b, 0xb8d9f7ddf3371db1}}, /* masked */
{11, 13, 9, {0xe245bd6d628e9363, 0x15d650cf3d312ec5}}, /* fed */
{11, 1, 17, {0x9cb30d9511d08be9, 0x80cd8705b2ae3908}}, /* fed */
{11, 17, 1, {0x84444d32c036d357, 0xabd36e9ae7836bd8}}, /* fed */
{11, 16, 7, {0xafacfa5bb478ccde, 0xaeacfd5a497ed050}}, /* fed */
{11, 2, 16, {0xe38b55e6be128340, 0xdd881f83e2aa38ad}}, /* fed */
{12, 13, 9, {0xd5495b9f6394542a, 0xf4494d2f9806341a}}, /* everything */
{12, 1, 17, {0x346107c763ee6e60, 0xfca7e785415b6815}}, /* everything */
{12, 17, 1, {0xdaf222d760deb0f7, 0xa88454fa8237305a}}, /* everything */
{12, 16, 7, {0x4a3caa18d228cdc3, 0xce9d48f17923b7ff}}, /* everything */
{12, 2, 16, {0xeaeb56ebd328e304, 0x6d02b317292b4487}}, /* everything */
{13, 13, 9, {0x181b5b3a0d09ebec, 0xfc1d9f723f2d5716}}, /* everything, large steps */
{13, 1, 17, {0xac91a01baad58072, 0x1f067c70ba43eca5}}, /* everything, large steps */
{13, 17, 1, {0x54eb40cb0a14d49c, 0xb5f266d7f7f18578}}, /* everything, large steps */
{13, 16, 7, {0xa6d30712c26d6ade, 0x0126bb2ad9310927}}, /* everything, large steps */
{13, 2, 16, {0xd3e7ad3311682ad3, 0x53a7446defacd1cf}}, /* everything, large steps */
{14, 13, 9, {0x17f958e616924a4e, 0x6bbff4d254ced6bc}}, /* everything, coupled */
{14, 1, 17, {0xc0eac51222971932, 0x3d447eab9a7ba150}}, /* everything, coupled */
{14, 17, 1, {0x33d77e94a47ab464, 0xbd997333f0302fe2}}, /* everything, coupled */
{14, 16, 7, {0xf60ed0591935f471, 0xbfaabd1f636372f4}}, /* everything, coupled */
{14, 2, 16, {0x67a1ef4c31cc4cfc, 0x64d6e8a33071a1e4}}, /* everything, coupled */
