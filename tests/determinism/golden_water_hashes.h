/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0xe690c15144df4947, 0x75f6ea83f94f61a8}}, /* beach */
{0, 1, 17, {0x0b0a8529a85631bd, 0x920972a2d4430450}}, /* beach */
{0, 17, 1, {0x91b076a87dd56eee, 0x6957decb95b00c01}}, /* beach */
{0, 16, 7, {0x3b0fa20d6c368306, 0x197ddea0ec1a8757}}, /* beach */
{0, 2, 16, {0x745bae2d9f39ceed, 0x30346aea6e28e47f}}, /* beach */
{1, 13, 9, {0xab34a39a49a6fc8f, 0x891bef42b2cc0c2b}}, /* dam */
{1, 1, 17, {0x25ad05a0c292ddb6, 0x106cab3284097ed7}}, /* dam */
{1, 17, 1, {0x4e1012f6bbf60050, 0x1683e8965d6cf97d}}, /* dam */
{1, 16, 7, {0xfec89a945dd3401f, 0x8b4defb7757e4539}}, /* dam */
{1, 2, 16, {0xaac7a9ed8ad40df8, 0x45ace8e8b5a79d75}}, /* dam */
{2, 13, 9, {0xfadc541cf30be339, 0x34aa4719de10f04f}}, /* flood */
{2, 1, 17, {0xfdb13d9dddae3162, 0x1bba080cefa3e759}}, /* flood */
{2, 17, 1, {0x84dcdbf7f0bc2b3f, 0x4d4bf4d6828ac341}}, /* flood */
{2, 16, 7, {0xc98ac1c06727484e, 0x420683ba11b24ca2}}, /* flood */
{2, 2, 16, {0x9969ae581d8926af, 0xe0a079fb7da5a336}}, /* flood */
{3, 13, 9, {0x3a9bf635f28e3f74, 0x6823316b1acdc8fb}}, /* weir */
{3, 1, 17, {0x84252bae5d5547e1, 0xfd32384464f6a8a6}}, /* weir */
{3, 17, 1, {0x3c200cb15850ac64, 0x93d3cdba66913fbe}}, /* weir */
{3, 16, 7, {0xb3f82037d0648b6b, 0x315187b7c313160b}}, /* weir */
{3, 2, 16, {0x78825d8a673da664, 0xec4a132f949dd22b}}, /* weir */
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
{6, 13, 9, {0x0b4b53a464e54263, 0xaf460e666f5fc46b}}, /* tide */
{6, 1, 17, {0x54d814b9d25da25f, 0xdfb076f9999dc857}}, /* tide */
{6, 17, 1, {0x616bb3d6395b86d5, 0xd66f1900bc5205f5}}, /* tide */
{6, 16, 7, {0x4ac20562058496c3, 0x69f3f1b8ad8dc2af}}, /* tide */
{6, 2, 16, {0x0e3644fcde0e37fa, 0x49586a8c78572324}}, /* tide */
{7, 13, 9, {0xab8edc1d749142a1, 0xa904c08dae40fed1}}, /* river */
{7, 1, 17, {0x0bf022df59761559, 0xafec364dbe32c728}}, /* river */
{7, 17, 1, {0x90812b82103d0bdd, 0x645f4088a4ffbaca}}, /* river */
{7, 16, 7, {0x45f63105eb458796, 0xd5280850ebab58b1}}, /* river */
{7, 2, 16, {0x9358a1bbc79a7277, 0x790f643b015b0088}}, /* river */
{8, 13, 9, {0xe8b9d74f3e3b41e4, 0x8b0b65705121cde7}}, /* torus */
{8, 1, 17, {0x313e2cd3165347ce, 0x1bd948f4e4c71a0d}}, /* torus */
{8, 17, 1, {0x4b0ad42f9f5936d6, 0x8c068eb1c8ba8ccf}}, /* torus */
{8, 16, 7, {0x240a90f75cc20524, 0x19b6bdd4ded7c6df}}, /* torus */
{8, 2, 16, {0x699d6a80082044fd, 0xd067b844831e5107}}, /* torus */
{9, 13, 9, {0x685449c367df7c34, 0xfddf89c84badf1a9}}, /* masked */
{9, 1, 17, {0x25226b653692210b, 0xd28bebf71893d1ae}}, /* masked */
{9, 17, 1, {0x1d326e3ce732cdfa, 0x33f3c06b72c03e8c}}, /* masked */
{9, 16, 7, {0x007e077e8746bddd, 0x1ea4b528ac880f49}}, /* masked */
{9, 2, 16, {0xc84b6b1dd312aefd, 0x0024e715f5ab37de}}, /* masked */
{10, 13, 9, {0x4c47f140b017c37e, 0xdbd6ffb0d64612cc}}, /* fed */
{10, 1, 17, {0xe73caee1ae846efd, 0x2fc46d06faf17185}}, /* fed */
{10, 17, 1, {0xd4a224799f0e354a, 0x3e98074c93252028}}, /* fed */
{10, 16, 7, {0xfdb4abc8f1981c62, 0xc26c0899b3b264a1}}, /* fed */
{10, 2, 16, {0xa5d1dcef5f1c4a3b, 0x286b6e45c2bd2e93}}, /* fed */
{11, 13, 9, {0xa4aca8e0394d867e, 0x0abf9c2bd95fde8f}}, /* everything */
{11, 1, 17, {0x954fe6e93bd7bc2e, 0x2fa27a9c7fb6cdf7}}, /* everything */
{11, 17, 1, {0xc64e1a8c725c67a2, 0x925513140fdcce12}}, /* everything */
{11, 16, 7, {0xfec5434f49e805e4, 0x2100b82a917a9633}}, /* everything */
{11, 2, 16, {0x6f6f83f1aea2a279, 0x22fe3bc4326fbeee}}, /* everything */
{12, 13, 9, {0xbfefb815d5c08193, 0xc91c55692adc7cc7}}, /* everything, long steps */
{12, 1, 17, {0xd35a54da06bea2ba, 0x63be81593288f5c0}}, /* everything, long steps */
{12, 17, 1, {0x30472bac6fe30d2c, 0xc88cfe34ccd9063e}}, /* everything, long steps */
{12, 16, 7, {0xf02f44dbd3cb7049, 0x69b3ceea19521b58}}, /* everything, long steps */
{12, 2, 16, {0x8b63103b163c9539, 0x0a0abadd970adb96}}, /* everything, long steps */
{13, 13, 9, {0xb90cecafcf7391b9, 0x85930df45eeb4c5a}}, /* hulls */
{13, 1, 17, {0xefc6e6dfd02ac6c0, 0x2c836ce9d7cf0f75}}, /* hulls */
{13, 17, 1, {0x89dc749364423a7b, 0x482c7da828a2f3be}}, /* hulls */
{13, 16, 7, {0x1ae81492f3b14a89, 0x31cf8fa74ef2132e}}, /* hulls */
{13, 2, 16, {0x4bf630ac44bf6a77, 0x6d917b54b6a5f657}}, /* hulls */
{14, 13, 9, {0xd435d6960cb2c81c, 0x2c3a836799ea18f9}}, /* hulls, long steps */
{14, 1, 17, {0xe5ffeb449ecc0286, 0x1ea32fa077ede671}}, /* hulls, long steps */
{14, 17, 1, {0x88be13cafbb527dd, 0x318d5a4e4e3a7e17}}, /* hulls, long steps */
{14, 16, 7, {0x38e4dcdd55823fed, 0x5ea625fdb73d5f7c}}, /* hulls, long steps */
{14, 2, 16, {0x36818430b1908b38, 0x6e83250120250d72}}, /* hulls, long steps */
