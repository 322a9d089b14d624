/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0x4616ad38e556fa10, 0xccdb904c3dad62b9}}, /* beach */
{0, 1, 17, {0x0b0a8529a85631bd, 0x920972a2d4430450}}, /* beach */
{0, 17, 1, {0x91b076a87dd56eee, 0x6957decb95b00c01}}, /* beach */
{0, 16, 7, {0xb08bf2b4f7f226ec, 0x9416679f50ba4193}}, /* beach */
{0, 2, 16, {0x745bae2d9f39ceed, 0x30346aea6e28e47f}}, /* beach */
{1, 13, 9, {0x028ca785b4f144f5, 0xe9f8a1d31efe1362}}, /* dam */
{1, 1, 17, {0xecdb26bc5b1e7eec, 0x7d4ccd182f396cfd}}, /* dam */
{1, 17, 1, {0x1fcd93a6615d713e, 0x3ea7f5a7c64321b1}}, /* dam */
{1, 16, 7, {0xd3b5540093440c18, 0x46daf8920b4c5468}}, /* dam */
{1, 2, 16, {0xf9c392929a86679f, 0x458791d2f94cf08f}}, /* dam */
{2, 13, 9, {0x50a689ddf5a53ae1, 0x088481e89ee42c23}}, /* flood */
{2, 1, 17, {0x49c2aa75d9e0d7f3, 0x50371d5db650f36d}}, /* flood */
{2, 17, 1, {0x423c672a3e4aa3fd, 0xcd2745d8e9cf84fd}}, /* flood */
{2, 16, 7, {0xfd95f8bf9ff5fbb2, 0xaec5685319e634d8}}, /* flood */
{2, 2, 16, {0x602dc4845c9ea7eb, 0x8c4e889121d29e03}}, /* flood */
{3, 13, 9, {0xd4ad5f5646f70261, 0x823389e65b582111}}, /* weir */
{3, 1, 17, {0x0ada2790caee2487, 0x686ce2749c44bef7}}, /* weir */
{3, 17, 1, {0x269e407816e6f158, 0x38543cc12e62b352}}, /* weir */
{3, 16, 7, {0x04eff7db40e176a4, 0x0778df9af7d6aa0a}}, /* weir */
{3, 2, 16, {0x78825d8a673da664, 0xdd13867e87b40d01}}, /* weir */
{4, 13, 9, {0x34ff9a256ba8112e, 0x380f62d35a5d541c}}, /* explicit */
{4, 1, 17, {0x198e4dec868efae1, 0x9bd595cdeda19578}}, /* explicit */
{4, 17, 1, {0xba518f52d22e4f33, 0x9597a377557876a4}}, /* explicit */
{4, 16, 7, {0xc4b96200e56e28c2, 0xd0c19653193d9022}}, /* explicit */
{4, 2, 16, {0x50a272351bf36b3a, 0x60fce1d8ab12313e}}, /* explicit */
{5, 13, 9, {0xc25686b6cf9e33ed, 0x12bfa964b08c9b8a}}, /* forward */
{5, 1, 17, {0xd2eec3c49f952ee8, 0x0a158bad57804522}}, /* forward */
{5, 17, 1, {0x659e9a0f86c3b3ca, 0xcb56a0b64b209b37}}, /* forward */
{5, 16, 7, {0xd72a3b17eeafe701, 0xa2032450d92bc4af}}, /* forward */
{5, 2, 16, {0x1562c493214caa8f, 0x19011cf8cd6b6fd1}}, /* forward */
{6, 13, 9, {0x82848151164c01c5, 0xb7aa84453dfadd57}}, /* tide */
{6, 1, 17, {0x54d814b9d25da25f, 0xdfb076f9999dc857}}, /* tide */
{6, 17, 1, {0x616bb3d6395b86d5, 0x59431f3f818a6151}}, /* tide */
{6, 16, 7, {0x3f33358f064f89cd, 0x805824bb28d8d993}}, /* tide */
{6, 2, 16, {0x0e3644fcde0e37fa, 0x49586a8c78572324}}, /* tide */
{7, 13, 9, {0x12e5018792f8e675, 0x5c3a6bf7834339ec}}, /* river */
{7, 1, 17, {0x0bf022df59761559, 0x2fe2b547ac76b05f}}, /* river */
{7, 17, 1, {0x00cf9dc2b663e646, 0x170e09030fc470ef}}, /* river */
{7, 16, 7, {0xa6c47866be8b8713, 0xfea0bf057a3c0da3}}, /* river */
{7, 2, 16, {0x9358a1bbc79a7277, 0xd5defa16bbd85854}}, /* river */
{8, 13, 9, {0xe8b9d74f3e3b41e4, 0x6ff3490b9960871f}}, /* torus */
{8, 1, 17, {0x313e2cd3165347ce, 0x06069fae6dbdb945}}, /* torus */
{8, 17, 1, {0x4b0ad42f9f5936d6, 0xc0c7db92ce165e64}}, /* torus */
{8, 16, 7, {0x240a90f75cc20524, 0xd776ccd4bab4ca17}}, /* torus */
{8, 2, 16, {0x699d6a80082044fd, 0x962b646db81dfdd6}}, /* torus */
{9, 13, 9, {0x685449c367df7c34, 0xd52e06c00dd0e03d}}, /* masked */
{9, 1, 17, {0x25226b653692210b, 0xd28bebf71893d1ae}}, /* masked */
{9, 17, 1, {0x1d326e3ce732cdfa, 0x33f3c06b72c03e8c}}, /* masked */
{9, 16, 7, {0x007e077e8746bddd, 0x1ea4b528ac880f49}}, /* masked */
{9, 2, 16, {0xc84b6b1dd312aefd, 0x0024e715f5ab37de}}, /* masked */
{10, 13, 9, {0x40759b9e2d8e627d, 0xf8dfc85bbecd9445}}, /* fed */
{10, 1, 17, {0xeb401a96a66eb344, 0xe33227e318a863b4}}, /* fed */
{10, 17, 1, {0x76a00fc9e757c8c6, 0x8bb0f004791a59d4}}, /* fed */
{10, 16, 7, {0xa6b8a73c2ee3a141, 0x8fe46a306e0a9772}}, /* fed */
{10, 2, 16, {0xa15770a68c8353e2, 0x97b4731338c1b0f1}}, /* fed */
{11, 13, 9, {0x96887706de05b2ca, 0x34f19f9db711ce0a}}, /* everything */
{11, 1, 17, {0x5b2566d68f791db5, 0xda40f4492fee7fe3}}, /* everything */
{11, 17, 1, {0x44996cadb85026a9, 0x6b1bfe9f5a4caacc}}, /* everything */
{11, 16, 7, {0x68c42ed61050e44e, 0x31d1bf9e38ff994b}}, /* everything */
{11, 2, 16, {0x9f27004d6271a61e, 0xba03fa3bbe517eda}}, /* everything */
{12, 13, 9, {0x64e4f6de52a879a5, 0xf8f0fbbaf06132a5}}, /* everything, long steps */
{12, 1, 17, {0x27fc469269520656, 0xa8870a195e046a5f}}, /* everything, long steps */
{12, 17, 1, {0x47ff0f3f2a19f778, 0x40da0300f2b439d1}}, /* everything, long steps */
{12, 16, 7, {0xb7e3c07edd950134, 0xf59271b8429910dd}}, /* everything, long steps */
{12, 2, 16, {0x63335f6384f97774, 0x7ffb6e762b621ad2}}, /* everything, long steps */
{13, 13, 9, {0x4f76696608b58119, 0x5feda6633d13c180}}, /* hulls */
{13, 1, 17, {0xbf35aa0d4d8000c6, 0xe0ec9a4c89362d3c}}, /* hulls */
{13, 17, 1, {0x544c3ca90c403446, 0x492e05376c88503b}}, /* hulls */
{13, 16, 7, {0xb2f80f3c358aba76, 0x0c267a66745a58c9}}, /* hulls */
{13, 2, 16, {0x12f19e39936c96a9, 0x43b6ed0f853e6f7d}}, /* hulls */
{14, 13, 9, {0xa6d291888d87dce5, 0xc085ab56763a04a2}}, /* hulls, long steps */
{14, 1, 17, {0x869a025290f01fcc, 0x565a3a886359232f}}, /* hulls, long steps */
{14, 17, 1, {0x8d41fe96725fe47b, 0x8ed862c8c8a4d475}}, /* hulls, long steps */
{14, 16, 7, {0x6e1226522903fe72, 0x9fed4e3cce57ca1f}}, /* hulls, long steps */
{14, 2, 16, {0x3135784e76e632cd, 0xb83bdfba0d0d9598}}, /* hulls, long steps */
