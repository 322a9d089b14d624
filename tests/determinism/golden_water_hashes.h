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
{2, 13, 9, {0xe4eba371f8bc6901, 0xe3d073c86ced1f53}}, /* flood */
{2, 1, 17, {0x883b1b847d432f57, 0x1c456aa5476c8be7}}, /* flood */
{2, 17, 1, {0xe8b63829874417da, 0xbd9f7e0cb0036f13}}, /* flood */
{2, 16, 7, {0xa61b2d23ecbfbd2a, 0x449362aa972a9a3e}}, /* flood */
{2, 2, 16, {0xf45e0b2c2ab60eed, 0x4aa4e7c3e66cfdbf}}, /* flood */
{3, 13, 9, {0x4d990f9a83409eee, 0x1be58c7d65468bac}}, /* weir */
{3, 1, 17, {0x0a15e49a7c78f5fd, 0xd93424a8144be30f}}, /* weir */
{3, 17, 1, {0x1493101efcc181f3, 0x0cced654e0648d41}}, /* weir */
{3, 16, 7, {0x2a28b2e57d351a66, 0x9c8d91f68d32a58b}}, /* weir */
{3, 2, 16, {0x10678b060dc19503, 0x898dfea82762cc8b}}, /* weir */
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
{7, 13, 9, {0x4c8437922e992e97, 0x2f28a8306d3915d4}}, /* river */
{7, 1, 17, {0x7a923f573c1717e2, 0x498604e1984179bf}}, /* river */
{7, 17, 1, {0xfe7b6a9ca868741e, 0xb1425c773756c51f}}, /* river */
{7, 16, 7, {0x4f145499cabc3418, 0xb17368a15f45efe9}}, /* river */
{7, 2, 16, {0xef420fe11d5f3a5e, 0x58681a4aef7a91a5}}, /* river */
{8, 13, 9, {0xc36e02d358180a8b, 0xf141c6d80c6b96b7}}, /* torus */
{8, 1, 17, {0xf867ed88a1185353, 0xc757699a9361334a}}, /* torus */
{8, 17, 1, {0x07552e16e95f4cd3, 0xad605bcde65077ce}}, /* torus */
{8, 16, 7, {0xb5cb80faa5441e8a, 0x1c8ae768e4ea551c}}, /* torus */
{8, 2, 16, {0x12147763826b0eb8, 0xeeab7d4efbe34f01}}, /* torus */
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
{11, 13, 9, {0x31eeed6940037b88, 0xd6c718cb91a61b35}}, /* everything */
{11, 1, 17, {0x9dc6438692b4b188, 0xb7d7bf12f19444b8}}, /* everything */
{11, 17, 1, {0xcb97b23da4aab6c6, 0xbdb00808862805a9}}, /* everything */
{11, 16, 7, {0xe44a0ac397a2b942, 0x0248edec456fd75f}}, /* everything */
{11, 2, 16, {0x59da9527a47cf0f1, 0xa5ed435aa48de551}}, /* everything */
{12, 13, 9, {0x55c48062f7d087ec, 0xa40883758e8f65eb}}, /* everything, long steps */
{12, 1, 17, {0xa78a41c559a0b002, 0xd0c98b4fb4cdc237}}, /* everything, long steps */
{12, 17, 1, {0xee10460b43ec32de, 0x4c8d715ee92b5116}}, /* everything, long steps */
{12, 16, 7, {0x2ff6c4fee11d9903, 0x696fe6582ff5f12c}}, /* everything, long steps */
{12, 2, 16, {0x8f01dd5ec3545d0f, 0xfe448664b1f68c6a}}, /* everything, long steps */
{13, 13, 9, {0x49eca0b8789a407b, 0xe129fca219e5ce42}}, /* hulls */
{13, 1, 17, {0x763ccb6d8fa29eaf, 0x2232f4081d7be85f}}, /* hulls */
{13, 17, 1, {0x1cbf3423ab9fe951, 0x1654e71272d23836}}, /* hulls */
{13, 16, 7, {0x4a88641011f7ab50, 0xd07965e81c9a56ec}}, /* hulls */
{13, 2, 16, {0x67ba1c9980ea9116, 0xd752c6ce6eb33c60}}, /* hulls */
{14, 13, 9, {0x70afef7e9560a2aa, 0x35b5cdbc1ee769d3}}, /* hulls, long steps */
{14, 1, 17, {0x001654b4eaae545f, 0x75bf3041c772541d}}, /* hulls, long steps */
{14, 17, 1, {0x26c33fa82b029383, 0x55825ce5e59b7f0f}}, /* hulls, long steps */
{14, 16, 7, {0xbe83af63eeafd79a, 0x16f7e76ee5dbf2d9}}, /* hulls, long steps */
{14, 2, 16, {0x808e7cc5caeb1cf8, 0x240a961b971b0ea8}}, /* hulls, long steps */
