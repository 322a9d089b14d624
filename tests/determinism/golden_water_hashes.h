/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0xe690c15144df4947, 0x75f6ea83f94f61a8}}, /* beach */
{0, 1, 17, {0x0b0a8529a85631bd, 0x920972a2d4430450}}, /* beach */
{0, 17, 1, {0x91b076a87dd56eee, 0x6957decb95b00c01}}, /* beach */
{0, 16, 7, {0x3b0fa20d6c368306, 0x197ddea0ec1a8757}}, /* beach */
{0, 2, 16, {0x745bae2d9f39ceed, 0x30346aea6e28e47f}}, /* beach */
{1, 13, 9, {0xab34a39a49a6fc8f, 0x2291b9e5d1132286}}, /* dam */
{1, 1, 17, {0x25ad05a0c292ddb6, 0x4777aa601219663b}}, /* dam */
{1, 17, 1, {0x4e1012f6bbf60050, 0xd0122e4e9f7d35e8}}, /* dam */
{1, 16, 7, {0xfec89a945dd3401f, 0x3e27cb263038cd5e}}, /* dam */
{1, 2, 16, {0xaac7a9ed8ad40df8, 0xec058aefd8c5866f}}, /* dam */
{2, 13, 9, {0xcca0c5a2a209ffb5, 0xa9982cce8e2d4826}}, /* flood */
{2, 1, 17, {0xbd361e9c46ee00eb, 0x265a785146c51cd7}}, /* flood */
{2, 17, 1, {0x083857beba879114, 0xaa1597a28b65aca6}}, /* flood */
{2, 16, 7, {0xa30b6cd942979e71, 0x8913cd1bcaf5c09d}}, /* flood */
{2, 2, 16, {0x985ca36cc7278ebc, 0x119c696e9bc588c7}}, /* flood */
{3, 13, 9, {0x3a9bf635f28e3f74, 0x195c42bdff3126c6}}, /* weir */
{3, 1, 17, {0x84252bae5d5547e1, 0x4231d6808a886ef7}}, /* weir */
{3, 17, 1, {0x3c200cb15850ac64, 0x6b2d02fe5fa20569}}, /* weir */
{3, 16, 7, {0xb3f82037d0648b6b, 0x9e6d484c7ce378e9}}, /* weir */
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
{6, 13, 9, {0x0b4b53a464e54263, 0xaf460e666f5fc46b}}, /* tide */
{6, 1, 17, {0x54d814b9d25da25f, 0xdfb076f9999dc857}}, /* tide */
{6, 17, 1, {0x616bb3d6395b86d5, 0xd66f1900bc5205f5}}, /* tide */
{6, 16, 7, {0x4ac20562058496c3, 0x69f3f1b8ad8dc2af}}, /* tide */
{6, 2, 16, {0x0e3644fcde0e37fa, 0x49586a8c78572324}}, /* tide */
{7, 13, 9, {0xab8edc1d749142a1, 0xc535d9f83969f39c}}, /* river */
{7, 1, 17, {0x0bf022df59761559, 0x2fe2b547ac76b05f}}, /* river */
{7, 17, 1, {0x90812b82103d0bdd, 0x28176ab50395896f}}, /* river */
{7, 16, 7, {0x45f63105eb458796, 0x980e724eb4b84a8f}}, /* river */
{7, 2, 16, {0x9358a1bbc79a7277, 0xd5defa16bbd85854}}, /* river */
{8, 13, 9, {0xe8b9d74f3e3b41e4, 0x6ff3490b9960871f}}, /* torus */
{8, 1, 17, {0x313e2cd3165347ce, 0x06069fae6dbdb945}}, /* torus */
{8, 17, 1, {0x4b0ad42f9f5936d6, 0xc0c7db92ce165e64}}, /* torus */
{8, 16, 7, {0x240a90f75cc20524, 0xd776ccd4bab4ca17}}, /* torus */
{8, 2, 16, {0x699d6a80082044fd, 0x962b646db81dfdd6}}, /* torus */
{9, 13, 9, {0x685449c367df7c34, 0xfddf89c84badf1a9}}, /* masked */
{9, 1, 17, {0x25226b653692210b, 0xd28bebf71893d1ae}}, /* masked */
{9, 17, 1, {0x1d326e3ce732cdfa, 0x33f3c06b72c03e8c}}, /* masked */
{9, 16, 7, {0x007e077e8746bddd, 0x1ea4b528ac880f49}}, /* masked */
{9, 2, 16, {0xc84b6b1dd312aefd, 0x0024e715f5ab37de}}, /* masked */
{10, 13, 9, {0x08c3d58ce6f43cc9, 0x51687ef6123dcfa7}}, /* fed */
{10, 1, 17, {0xe73caee1ae846efd, 0x02da07916b1f6a97}}, /* fed */
{10, 17, 1, {0xd4a224799f0e354a, 0x2b043cfe74ab4e5d}}, /* fed */
{10, 16, 7, {0x50986e0e95f67336, 0xd12ded897e35e6a8}}, /* fed */
{10, 2, 16, {0x999b26b8da85dea4, 0xbdfd094b664d0f88}}, /* fed */
{11, 13, 9, {0xa950d394590640d1, 0xb383f295847e9700}}, /* everything */
{11, 1, 17, {0x9216a6ce04af541d, 0xb5691a8801087b2f}}, /* everything */
{11, 17, 1, {0xc64e1a8c725c67a2, 0xa2a5ded7d45497fc}}, /* everything */
{11, 16, 7, {0x356d9e3ceb843d54, 0xfea886510debce46}}, /* everything */
{11, 2, 16, {0x67b12cee2736da33, 0xcff95e124a33ce15}}, /* everything */
{12, 13, 9, {0xd8904353b1c77fa2, 0xcc0c4dd3da1f38b0}}, /* everything, long steps */
{12, 1, 17, {0xc48b7fe5fae5073c, 0x82efc1d56b6474ed}}, /* everything, long steps */
{12, 17, 1, {0x380bb0016719faa8, 0xd0af33f5cb9a59f0}}, /* everything, long steps */
{12, 16, 7, {0x11c7059638ac2c7d, 0x03aabc6369b3d4ab}}, /* everything, long steps */
{12, 2, 16, {0x71d729b6da99df2f, 0x34e70a5e622e148c}}, /* everything, long steps */
{13, 13, 9, {0xb90cecafcf7391b9, 0x85930df45eeb4c5a}}, /* hulls */
{13, 1, 17, {0xefc6e6dfd02ac6c0, 0x2c836ce9d7cf0f75}}, /* hulls */
{13, 17, 1, {0x89dc749364423a7b, 0x482c7da828a2f3be}}, /* hulls */
{13, 16, 7, {0x1ae81492f3b14a89, 0x31cf8fa74ef2132e}}, /* hulls */
{13, 2, 16, {0x4bf630ac44bf6a77, 0x6d917b54b6a5f657}}, /* hulls */
{14, 13, 9, {0xd23a1defb0da4e62, 0xb7d5c40890173cf9}}, /* hulls, long steps */
{14, 1, 17, {0x8127dad57aeae3d4, 0xf852c790440263d9}}, /* hulls, long steps */
{14, 17, 1, {0xaee3c1824abc0e06, 0xd6c6679490148b68}}, /* hulls, long steps */
{14, 16, 7, {0x472847116ce91a1c, 0x87fd28abb4c2c4f0}}, /* hulls, long steps */
{14, 2, 16, {0xbe5f4bcf6e943682, 0x5d7d77f487f14752}}, /* hulls, long steps */
