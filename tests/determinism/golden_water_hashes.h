/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0xf8857b11e89d2b15, 0x449ae9951ffd8574}}, /* beach */
{0, 1, 17, {0xaae71d8a3356e11e, 0x3722ec198108f678}}, /* beach */
{0, 17, 1, {0x0e39abe19b7879f3, 0xa47d51adb49fee25}}, /* beach */
{0, 16, 7, {0x75a0dc56fe938c3b, 0x51a108e6a0c04e23}}, /* beach */
{0, 2, 16, {0x3c869512f5872370, 0xf92ccf6d7440c349}}, /* beach */
{1, 13, 9, {0x114578e3b569c2d7, 0x892d63f196fefb5e}}, /* dam */
{1, 1, 17, {0xf3af0fadff5d5608, 0x12cd30ac06342fa6}}, /* dam */
{1, 17, 1, {0xefbc6f9d00c57d84, 0x78a33969e6e8de1f}}, /* dam */
{1, 16, 7, {0x8a830f9b070d14ea, 0x388da92c1abd680d}}, /* dam */
{1, 2, 16, {0xc0ba74b088b722cb, 0x5cfc2d6d6ce4b8a7}}, /* dam */
{2, 13, 9, {0xdafe24ac53bf693e, 0xb7cb5402a8e78c95}}, /* flood */
{2, 1, 17, {0x1617543c38692986, 0xf36ad29f26b6ceef}}, /* flood */
{2, 17, 1, {0x52603b80571410ef, 0x4b659469ca27662a}}, /* flood */
{2, 16, 7, {0xa2d5dc14f5de7913, 0xcb4ec34fdb52126e}}, /* flood */
{2, 2, 16, {0x9379b7cd3b70c9c2, 0x020d7f258ab66218}}, /* flood */
{3, 13, 9, {0x267cf267e9224123, 0x1c8eb6a00154717c}}, /* coupled */
{3, 1, 17, {0x5c58421e823a19ab, 0xd0f14b4e62a891c5}}, /* coupled */
{3, 17, 1, {0x9a5ed2bcd33c8aaa, 0xdafee58e42d3fdfd}}, /* coupled */
{3, 16, 7, {0xb597e54e697f151a, 0xdf0c1de4ed194f97}}, /* coupled */
{3, 2, 16, {0x75e6c95d6a179f6e, 0x052d23f8966549a5}}, /* coupled */
{4, 13, 9, {0xed7535631a80cf7c, 0xa036c297022930b0}}, /* coupled, advected */
{4, 1, 17, {0x64e9f27b6574a990, 0x647b627f88dc7875}}, /* coupled, advected */
{4, 17, 1, {0x2808b6237ffcfc49, 0x160420fda2a1ef9f}}, /* coupled, advected */
{4, 16, 7, {0x7fbbeada43e12d17, 0x62571a035a26baba}}, /* coupled, advected */
{4, 2, 16, {0x9b688d5f36e7a019, 0x7d248581d9d0061b}}, /* coupled, advected */
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
{7, 13, 9, {0xa8a1d2e3d5a78dff, 0x28c3ed99251efc5f}}, /* tide */
{7, 1, 17, {0xd1af62a482527ccc, 0xc20c8667f3c4ad13}}, /* tide */
{7, 17, 1, {0x1a9b16aac865888c, 0xb4972d8b8a1349c0}}, /* tide */
{7, 16, 7, {0x0d2effc78c721d1b, 0x140eecd3cca27d15}}, /* tide */
{7, 2, 16, {0xdf4466f15705aed6, 0x179f7892123c6c11}}, /* tide */
{8, 13, 9, {0xf14d7931f1826f2a, 0xc90d2285c0337a4f}}, /* river */
{8, 1, 17, {0x271678daea4b8910, 0xe7bbf3d12c4b95bb}}, /* river */
{8, 17, 1, {0x0be3220802035d73, 0x39e107df40d7cd40}}, /* river */
{8, 16, 7, {0x6b97d569d17b6605, 0x3155ac9714818e96}}, /* river */
{8, 2, 16, {0x0874f8c690653cd5, 0x0f6c925feff472ff}}, /* river */
{9, 13, 9, {0x644e289ae36b86d4, 0xa073ecc42f123ed0}}, /* torus */
{9, 1, 17, {0x3e2bd7cd1976a460, 0x0a55d8e1e5d8382f}}, /* torus */
{9, 17, 1, {0x8a31d22521c236a7, 0xb65bfa1a04a853a0}}, /* torus */
{9, 16, 7, {0xe496bb4cae2a0c36, 0x36b11a32c5c96cec}}, /* torus */
{9, 2, 16, {0x82adb15e554953fa, 0x9396cbb36fa959cf}}, /* torus */
{10, 13, 9, {0xe5d21c98a022ef1c, 0xc3d29056e901e456}}, /* masked */
{10, 1, 17, {0x26a46ed2f397dd15, 0x57084d37e8d3e142}}, /* masked */
{10, 17, 1, {0xd881b9560130f03c, 0x1d236621c4e83953}}, /* masked */
{10, 16, 7, {0x740f2adf9bc7762f, 0x731ebe1092dc50ab}}, /* masked */
{10, 2, 16, {0xaa239e0f5c68bc3b, 0xb8d9f7ddf3371db1}}, /* masked */
{11, 13, 9, {0xe245bd6d628e9363, 0x2c326a99d43a2cb9}}, /* fed */
{11, 1, 17, {0x9cb30d9511d08be9, 0x0ece1f9794314ec9}}, /* fed */
{11, 17, 1, {0x84444d32c036d357, 0x02862e41fa932ba6}}, /* fed */
{11, 16, 7, {0xafacfa5bb478ccde, 0x123254ce8a60e760}}, /* fed */
{11, 2, 16, {0xe38b55e6be128340, 0x3b958a741ae62600}}, /* fed */
{12, 13, 9, {0xd5495b9f6394542a, 0xd93265cce8e28675}}, /* everything */
{12, 1, 17, {0x346107c763ee6e60, 0xb3448454ed28f8c4}}, /* everything */
{12, 17, 1, {0xdaf222d760deb0f7, 0xa88454fa8237305a}}, /* everything */
{12, 16, 7, {0x4a3caa18d228cdc3, 0x5953dcf835f452f2}}, /* everything */
{12, 2, 16, {0xeaeb56ebd328e304, 0xc61b21c57b6b87a0}}, /* everything */
{13, 13, 9, {0x181b5b3a0d09ebec, 0x5df412c936f9df3f}}, /* everything, large steps */
{13, 1, 17, {0xac91a01baad58072, 0x25fb5213165e1477}}, /* everything, large steps */
{13, 17, 1, {0x54eb40cb0a14d49c, 0xbd4c3568bd2dea81}}, /* everything, large steps */
{13, 16, 7, {0x996ef2af3502abac, 0xda3f97e1cc07b5b7}}, /* everything, large steps */
{13, 2, 16, {0xd3e7ad3311682ad3, 0xc2dbdd5a7f2794b0}}, /* everything, large steps */
{14, 13, 9, {0x17f958e616924a4e, 0x0262bebf22d50c88}}, /* everything, coupled */
{14, 1, 17, {0xc0eac51222971932, 0xc8f3dd4e642bf14a}}, /* everything, coupled */
{14, 17, 1, {0x33d77e94a47ab464, 0xbd997333f0302fe2}}, /* everything, coupled */
{14, 16, 7, {0xf60ed0591935f471, 0xe82af208de3db4fb}}, /* everything, coupled */
{14, 2, 16, {0x67a1ef4c31cc4cfc, 0x503c939eea2ce510}}, /* everything, coupled */
