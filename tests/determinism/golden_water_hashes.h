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
{2, 13, 9, {0x28dbc4ef7892afc7, 0x600bdbc31cb2ad5c}}, /* flood */
{2, 1, 17, {0x16438bfe619190b2, 0x8e5e30b9e6ee0304}}, /* flood */
{2, 17, 1, {0x4ef0a89117c8d20f, 0x2f8573b87bf64c1f}}, /* flood */
{2, 16, 7, {0x9cb89c35aaeffc7b, 0xcc06599f21adbbbf}}, /* flood */
{2, 2, 16, {0x8f78c39abc0d0830, 0xb350bcdfd94be1d1}}, /* flood */
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
{6, 13, 9, {0x0b4b53a464e54263, 0xe6602d6affbe06d3}}, /* tide */
{6, 1, 17, {0x54d814b9d25da25f, 0xdfb076f9999dc857}}, /* tide */
{6, 17, 1, {0x616bb3d6395b86d5, 0x56ea94cb5298ca68}}, /* tide */
{6, 16, 7, {0x4ac20562058496c3, 0x873f5523df752869}}, /* tide */
{6, 2, 16, {0x0e3644fcde0e37fa, 0x9b8f043242023cb7}}, /* tide */
{7, 13, 9, {0xdfc237fcc41f39be, 0x9fab60d1225d4235}}, /* river */
{7, 1, 17, {0x064922632e99253a, 0x70bac67f0a59691d}}, /* river */
{7, 17, 1, {0xce191ef03978fa91, 0x53a5389176fbc2cb}}, /* river */
{7, 16, 7, {0x0920fa492656dc72, 0x7a86dea6387a0332}}, /* river */
{7, 2, 16, {0x38932bee4f612ff3, 0xaf8951a3adc72da9}}, /* river */
{8, 13, 9, {0xd1d1a2a962bef1c8, 0x344f2dd611460740}}, /* torus */
{8, 1, 17, {0x43d1c128d33eb8da, 0xf711c204a9a1bd2c}}, /* torus */
{8, 17, 1, {0x9d9954ee3f9ee7fa, 0x36f42e236ec538ae}}, /* torus */
{8, 16, 7, {0x74a8fd440dc1d18c, 0x5ea2a2d78d6a565d}}, /* torus */
{8, 2, 16, {0x202d3eaaebe01dca, 0x0ab0fea86480ee29}}, /* torus */
{9, 13, 9, {0x685449c367df7c34, 0xfddf89c84badf1a9}}, /* masked */
{9, 1, 17, {0x25226b653692210b, 0xd28bebf71893d1ae}}, /* masked */
{9, 17, 1, {0x1d326e3ce732cdfa, 0x33f3c06b72c03e8c}}, /* masked */
{9, 16, 7, {0x007e077e8746bddd, 0x1ea4b528ac880f49}}, /* masked */
{9, 2, 16, {0xc84b6b1dd312aefd, 0x0024e715f5ab37de}}, /* masked */
{10, 13, 9, {0xc016b592ad94c3fe, 0x281ca65ef5eb5239}}, /* fed */
{10, 1, 17, {0xe73caee1ae846efd, 0x2fc46d06faf17185}}, /* fed */
{10, 17, 1, {0xd4a224799f0e354a, 0x3e98074c93252028}}, /* fed */
{10, 16, 7, {0x439d6531ed996d59, 0xc9e50d630623e061}}, /* fed */
{10, 2, 16, {0x61975d8b8520856a, 0x25e11d339c20be05}}, /* fed */
{11, 13, 9, {0xe499d7b2e5bc2aee, 0x11cacc1319758126}}, /* everything */
{11, 1, 17, {0x6339f8b23d39866d, 0xe3de2b56fb951360}}, /* everything */
{11, 17, 1, {0xc5537dfaa83a5044, 0x3a658e7352b4777a}}, /* everything */
{11, 16, 7, {0x54ee8188cfeb0de9, 0x03ab9fb1d0876a64}}, /* everything */
{11, 2, 16, {0xee2aed348b12e5ad, 0xd74b40a321291b83}}, /* everything */
{12, 13, 9, {0xc5840e0723e76af7, 0x0157b1a7314c77f7}}, /* everything, long steps */
{12, 1, 17, {0xaea4bfd74a004334, 0x9b868ba524bceead}}, /* everything, long steps */
{12, 17, 1, {0x8ffd582147697228, 0x368b6ba214c749ef}}, /* everything, long steps */
{12, 16, 7, {0xb98095e4720b45bd, 0x29d8bd03081c36f4}}, /* everything, long steps */
{12, 2, 16, {0x5b30c9c21eac8c29, 0x029a28905d295148}}, /* everything, long steps */
{13, 13, 9, {0xc10f2419498ec1cf, 0x0c5b81818e843b98}}, /* hulls */
{13, 1, 17, {0xefc6e6dfd02ac6c0, 0xdb8e5fc1b4daa8e6}}, /* hulls */
{13, 17, 1, {0x1b1c6d57f7439e98, 0xb0f69705ff1e3bdd}}, /* hulls */
{13, 16, 7, {0xb27bfe6e83cb1514, 0xa4d85c5d664f872e}}, /* hulls */
{13, 2, 16, {0x5ea63094ce19f620, 0xb3f920b109ec706e}}, /* hulls */
{14, 13, 9, {0x0d5eb04fb63e7de2, 0xe4c08de959ea1999}}, /* hulls, long steps */
{14, 1, 17, {0x0ad3ac63be728f5d, 0x69087a48e9e89a63}}, /* hulls, long steps */
{14, 17, 1, {0x7db98bc17d5ee77d, 0x545d187e4adeb8e4}}, /* hulls, long steps */
{14, 16, 7, {0x2670cea1bb38e66e, 0xb7eb9ba23c8c296f}}, /* hulls, long steps */
{14, 2, 16, {0xac4cbaf3b6b84f17, 0xe38783e2642f3e09}}, /* hulls, long steps */
