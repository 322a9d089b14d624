/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0x5924b7bd06ad9eb2, 0x449ae9951ffd8574}}, /* beach */
{0, 1, 17, {0xd560f8883788d26a, 0x3722ec198108f678}}, /* beach */
{0, 17, 1, {0x6c618ff02c830b89, 0xa47d51adb49fee25}}, /* beach */
{0, 16, 7, {0xa4073d4a9a350489, 0x51a108e6a0c04e23}}, /* beach */
{0, 2, 16, {0x377a189f7e8d9188, 0xf92ccf6d7440c349}}, /* beach */
{1, 13, 9, {0xbb8987b0151609b5, 0x892d63f196fefb5e}}, /* dam */
{1, 1, 17, {0x282e8f38511bb974, 0x12cd30ac06342fa6}}, /* dam */
{1, 17, 1, {0x08dfc81a15ac677a, 0x78a33969e6e8de1f}}, /* dam */
{1, 16, 7, {0x9f00e7e0b566ed92, 0x388da92c1abd680d}}, /* dam */
{1, 2, 16, {0x8ae5398e8476de93, 0x5cfc2d6d6ce4b8a7}}, /* dam */
{2, 13, 9, {0xca0995c2ea5065f4, 0xb7cb5402a8e78c95}}, /* flood */
{2, 1, 17, {0x1717590a72a84ec0, 0xf36ad29f26b6ceef}}, /* flood */
{2, 17, 1, {0x1dab17e80d50df0b, 0x4b659469ca27662a}}, /* flood */
{2, 16, 7, {0x4c5c7e364a2709fe, 0xcb4ec34fdb52126e}}, /* flood */
{2, 2, 16, {0x91a77c19aec996f5, 0x020d7f258ab66218}}, /* flood */
{3, 13, 9, {0xdf401f83e0139ed6, 0x1c8eb6a00154717c}}, /* coupled */
{3, 1, 17, {0x5c58421e823a19ab, 0xd0f14b4e62a891c5}}, /* coupled */
{3, 17, 1, {0x71bd071fbc3fe505, 0xdafee58e42d3fdfd}}, /* coupled */
{3, 16, 7, {0x2a8c71530039de3f, 0xdf0c1de4ed194f97}}, /* coupled */
{3, 2, 16, {0xefcc15acf1a0b536, 0x052d23f8966549a5}}, /* coupled */
{4, 13, 9, {0x489c31944a66b784, 0xa036c297022930b0}}, /* coupled, advected */
{4, 1, 17, {0x64e9f27b6574a990, 0x647b627f88dc7875}}, /* coupled, advected */
{4, 17, 1, {0x5e94b4f0c843e093, 0x160420fda2a1ef9f}}, /* coupled, advected */
{4, 16, 7, {0x52062d6190beea74, 0x62571a035a26baba}}, /* coupled, advected */
{4, 2, 16, {0x9b688d5f36e7a019, 0x7d248581d9d0061b}}, /* coupled, advected */
{5, 13, 9, {0xb16a029e51ef00ce, 0x80c3ef997b8ec468}}, /* explicit */
{5, 1, 17, {0x9f7b5526b245474e, 0x00ca7bcf66f4ac98}}, /* explicit */
{5, 17, 1, {0xab2c7c1d392f81a2, 0x239501211c808804}}, /* explicit */
{5, 16, 7, {0x6310e3bf4db6ded6, 0xc427b910646f13ac}}, /* explicit */
{5, 2, 16, {0xb34f888b81459f2e, 0xa85e42e7a8d2cd4f}}, /* explicit */
{6, 13, 9, {0x57d7103d25b73978, 0x7b2a5e2cb981b972}}, /* forward */
{6, 1, 17, {0xcdfd503727057e33, 0xb834c23b6304cfa7}}, /* forward */
{6, 17, 1, {0x12c24e57e4ac6392, 0x9852970dc04e34a3}}, /* forward */
{6, 16, 7, {0x6a0e5abc83ffe9fa, 0xc25ccb156a01b079}}, /* forward */
{6, 2, 16, {0xd3c7c4e33a79d3c3, 0x6e1245d680165b2c}}, /* forward */
{7, 13, 9, {0x9cb770f9c6270ab2, 0x28c3ed99251efc5f}}, /* tide */
{7, 1, 17, {0xdcddc9e259f9d09e, 0xc20c8667f3c4ad13}}, /* tide */
{7, 17, 1, {0x33f8fdeee1d30c8c, 0xb4972d8b8a1349c0}}, /* tide */
{7, 16, 7, {0x27eeed90be9675e2, 0x140eecd3cca27d15}}, /* tide */
{7, 2, 16, {0xf79b6e2a18eba4e1, 0x179f7892123c6c11}}, /* tide */
{8, 13, 9, {0x699c99f373abfb56, 0xc90d2285c0337a4f}}, /* river */
{8, 1, 17, {0x918eef4b3aeca5cd, 0xe7bbf3d12c4b95bb}}, /* river */
{8, 17, 1, {0xf0011fffac5d615b, 0x39e107df40d7cd40}}, /* river */
{8, 16, 7, {0x4eda9818ac9daa11, 0x3155ac9714818e96}}, /* river */
{8, 2, 16, {0xa2939e5b1f42aabc, 0x0f6c925feff472ff}}, /* river */
{9, 13, 9, {0x4e8b1d5be87b2246, 0xa073ecc42f123ed0}}, /* torus */
{9, 1, 17, {0x69ceb8d2f2e57a75, 0x0a55d8e1e5d8382f}}, /* torus */
{9, 17, 1, {0x5146f44ac38bfcf7, 0xb65bfa1a04a853a0}}, /* torus */
{9, 16, 7, {0xc9597e1295817952, 0x36b11a32c5c96cec}}, /* torus */
{9, 2, 16, {0x36b0c472faff69d9, 0x9396cbb36fa959cf}}, /* torus */
{10, 13, 9, {0xea94408142a7556d, 0xc3d29056e901e456}}, /* masked */
{10, 1, 17, {0x15b51b3ad15c1b0b, 0x57084d37e8d3e142}}, /* masked */
{10, 17, 1, {0x2a0cf6e46216333a, 0x1d236621c4e83953}}, /* masked */
{10, 16, 7, {0x15970cb9ee3bd9ef, 0x731ebe1092dc50ab}}, /* masked */
{10, 2, 16, {0xaede4852adffdada, 0xb8d9f7ddf3371db1}}, /* masked */
{11, 13, 9, {0x9c02c3c65acda8ea, 0x2c326a99d43a2cb9}}, /* fed */
{11, 1, 17, {0xa31c6ac5fbeffc37, 0x0ece1f9794314ec9}}, /* fed */
{11, 17, 1, {0x894c45ac3fd9bc8f, 0x02862e41fa932ba6}}, /* fed */
{11, 16, 7, {0xed3e14b9a7b22a0c, 0x123254ce8a60e760}}, /* fed */
{11, 2, 16, {0xd762cdcfd00d0651, 0x3b958a741ae62600}}, /* fed */
{12, 13, 9, {0xeca563eda27cf6fa, 0xd93265cce8e28675}}, /* everything */
{12, 1, 17, {0x8cf27a8ef2d24f9d, 0xb3448454ed28f8c4}}, /* everything */
{12, 17, 1, {0xc62738cf8d562cf9, 0xa88454fa8237305a}}, /* everything */
{12, 16, 7, {0x28d2e9ab459db4d3, 0x5953dcf835f452f2}}, /* everything */
{12, 2, 16, {0xfa3899dba4d6b609, 0xc61b21c57b6b87a0}}, /* everything */
{13, 13, 9, {0x03a526db7e2953f8, 0x5df412c936f9df3f}}, /* everything, large steps */
{13, 1, 17, {0xea272a941c2b534b, 0x25fb5213165e1477}}, /* everything, large steps */
{13, 17, 1, {0x6fe3da11e4557be3, 0xbd4c3568bd2dea81}}, /* everything, large steps */
{13, 16, 7, {0x117dfb91c9033571, 0xda3f97e1cc07b5b7}}, /* everything, large steps */
{13, 2, 16, {0xc5afa9c748103153, 0xc2dbdd5a7f2794b0}}, /* everything, large steps */
{14, 13, 9, {0x2fa2c194fe244f04, 0x0262bebf22d50c88}}, /* everything, coupled */
{14, 1, 17, {0xc0eac51222971932, 0xc8f3dd4e642bf14a}}, /* everything, coupled */
{14, 17, 1, {0x57a86662e4425ab4, 0xbd997333f0302fe2}}, /* everything, coupled */
{14, 16, 7, {0x6fd370f9b7648c42, 0xe82af208de3db4fb}}, /* everything, coupled */
{14, 2, 16, {0x3b4c3b76ab0aede9, 0x503c939eea2ce510}}, /* everything, coupled */
