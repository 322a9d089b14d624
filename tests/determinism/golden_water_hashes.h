/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0xda4d7844d92dd842, 0x75f6ea83f94f61a8}}, /* beach */
{0, 1, 17, {0x0b0a8529a85631bd, 0x920972a2d4430450}}, /* beach */
{0, 17, 1, {0x91b076a87dd56eee, 0x6957decb95b00c01}}, /* beach */
{0, 16, 7, {0x03f804daa708cf10, 0x197ddea0ec1a8757}}, /* beach */
{0, 2, 16, {0x2d6c24cb63cec1ee, 0x30346aea6e28e47f}}, /* beach */
{1, 13, 9, {0x8316238b2b890ac9, 0x891bef42b2cc0c2b}}, /* dam */
{1, 1, 17, {0x25ad05a0c292ddb6, 0x106cab3284097ed7}}, /* dam */
{1, 17, 1, {0x4e1012f6bbf60050, 0x1683e8965d6cf97d}}, /* dam */
{1, 16, 7, {0xbaf01de40d5fd03c, 0x8b4defb7757e4539}}, /* dam */
{1, 2, 16, {0xaac7a9ed8ad40df8, 0x45ace8e8b5a79d75}}, /* dam */
{2, 13, 9, {0x972611f6de091a5f, 0xf8df51e633f7dcc6}}, /* flood */
{2, 1, 17, {0x0f53e7ef143b29af, 0xe20c64b11bb5522c}}, /* flood */
{2, 17, 1, {0xc54443d18cd80528, 0x3939650259c245c3}}, /* flood */
{2, 16, 7, {0x9e28c86647612d42, 0xae144298fd58f022}}, /* flood */
{2, 2, 16, {0x1f0f9fac8f11588d, 0x5c338440495340dc}}, /* flood */
{3, 13, 9, {0xd5921faa7520f464, 0x1be58c7d65468bac}}, /* weir */
{3, 1, 17, {0xdabbe37cff3a16a3, 0xd93424a8144be30f}}, /* weir */
{3, 17, 1, {0x297eac0c96e512e5, 0x0cced654e0648d41}}, /* weir */
{3, 16, 7, {0x2dca898a75adcc6c, 0x9c8d91f68d32a58b}}, /* weir */
{3, 2, 16, {0xd898db8aa6de8af6, 0x898dfea82762cc8b}}, /* weir */
{4, 13, 9, {0xca2b78660bade6cd, 0x380f62d35a5d541c}}, /* explicit */
{4, 1, 17, {0x198e4dec868efae1, 0x9bd595cdeda19578}}, /* explicit */
{4, 17, 1, {0xba518f52d22e4f33, 0x9597a377557876a4}}, /* explicit */
{4, 16, 7, {0xa7f1a2b1cd43cd5d, 0xd0c19653193d9022}}, /* explicit */
{4, 2, 16, {0x5e250c3e42134427, 0x60fce1d8ab12313e}}, /* explicit */
{5, 13, 9, {0xc25686b6cf9e33ed, 0x12bfa964b08c9b8a}}, /* forward */
{5, 1, 17, {0xd2eec3c49f952ee8, 0x0a158bad57804522}}, /* forward */
{5, 17, 1, {0x659e9a0f86c3b3ca, 0xcb56a0b64b209b37}}, /* forward */
{5, 16, 7, {0xd72a3b17eeafe701, 0xa2032450d92bc4af}}, /* forward */
{5, 2, 16, {0x1562c493214caa8f, 0x19011cf8cd6b6fd1}}, /* forward */
{6, 13, 9, {0xb287d9c2c8956280, 0xe6602d6affbe06d3}}, /* tide */
{6, 1, 17, {0x54d814b9d25da25f, 0xdfb076f9999dc857}}, /* tide */
{6, 17, 1, {0x81fdb9e0a1986d71, 0x56ea94cb5298ca68}}, /* tide */
{6, 16, 7, {0x7e9a6ec8eef256e2, 0x873f5523df752869}}, /* tide */
{6, 2, 16, {0x5023eaa9b8ed42a7, 0x9b8f043242023cb7}}, /* tide */
{7, 13, 9, {0xaf8ff822c97f31c6, 0x2f28a8306d3915d4}}, /* river */
{7, 1, 17, {0x7a923f573c1717e2, 0x498604e1984179bf}}, /* river */
{7, 17, 1, {0x2490257514673ca8, 0xb1425c773756c51f}}, /* river */
{7, 16, 7, {0x4b9e5113442ad649, 0xb17368a15f45efe9}}, /* river */
{7, 2, 16, {0x62d04c8334b6eb76, 0x58681a4aef7a91a5}}, /* river */
{8, 13, 9, {0xc36e02d358180a8b, 0xf141c6d80c6b96b7}}, /* torus */
{8, 1, 17, {0xf867ed88a1185353, 0xc757699a9361334a}}, /* torus */
{8, 17, 1, {0x07552e16e95f4cd3, 0xad605bcde65077ce}}, /* torus */
{8, 16, 7, {0xb5cb80faa5441e8a, 0x1c8ae768e4ea551c}}, /* torus */
{8, 2, 16, {0x12147763826b0eb8, 0xeeab7d4efbe34f01}}, /* torus */
{9, 13, 9, {0xe245b1efb2f7be5f, 0xfddf89c84badf1a9}}, /* masked */
{9, 1, 17, {0x7698e7c1e67260b4, 0xd28bebf71893d1ae}}, /* masked */
{9, 17, 1, {0x42f16eda1a387ceb, 0x33f3c06b72c03e8c}}, /* masked */
{9, 16, 7, {0x5288f8bddfd488d4, 0x1ea4b528ac880f49}}, /* masked */
{9, 2, 16, {0x82af3b3344e80e47, 0x0024e715f5ab37de}}, /* masked */
{10, 13, 9, {0x685001fa6f17d007, 0xf83bae19527e766d}}, /* fed */
{10, 1, 17, {0x64d209cd2953b013, 0x2fc46d06faf17185}}, /* fed */
{10, 17, 1, {0x81994606cb52f44e, 0x3e98074c93252028}}, /* fed */
{10, 16, 7, {0xf8af037e343dca2f, 0xc9e50d630623e061}}, /* fed */
{10, 2, 16, {0xf838dc643be43641, 0x25e11d339c20be05}}, /* fed */
{11, 13, 9, {0xf3534dd76644caa4, 0xd6c718cb91a61b35}}, /* everything */
{11, 1, 17, {0x47cd6cf9ea093b6c, 0xb7d7bf12f19444b8}}, /* everything */
{11, 17, 1, {0x18a450ee68867fd8, 0xbdb00808862805a9}}, /* everything */
{11, 16, 7, {0x901cb511f9f2eef5, 0x0248edec456fd75f}}, /* everything */
{11, 2, 16, {0x3f1d92661385a65c, 0xee444c938dabe57d}}, /* everything */
{12, 13, 9, {0x960bcc7d157d19f2, 0xb0eb6636b3ad33ca}}, /* everything, long steps */
{12, 1, 17, {0x1f23410be325dfd8, 0xd0c98b4fb4cdc237}}, /* everything, long steps */
{12, 17, 1, {0xb6b16dc695889971, 0x0456b0fa653d6e7e}}, /* everything, long steps */
{12, 16, 7, {0x1e62d30f9ab4d3b4, 0x17d071e4dafbb8aa}}, /* everything, long steps */
{12, 2, 16, {0x843950e7082df9f4, 0xdcb3a2a8f0a77d96}}, /* everything, long steps */
{13, 13, 9, {0xb20dfa7c9b435b4a, 0x094a4e80fd022d63}}, /* hulls */
{13, 1, 17, {0x58c35d8fe1235aa2, 0x67744698a684d5f6}}, /* hulls */
{13, 17, 1, {0xb6f148e9cb79a01a, 0xb687179be68c8d64}}, /* hulls */
{13, 16, 7, {0x075cd184278e4d60, 0xae7968057704e2e4}}, /* hulls */
{13, 2, 16, {0x351c9857c9c6bfed, 0x5d3a53f7be820dc3}}, /* hulls */
{14, 13, 9, {0xa572df17bcd91cb4, 0x0d8adb638032537e}}, /* hulls, long steps */
{14, 1, 17, {0x202dc9d3ac0e643e, 0x718b653c49a03b78}}, /* hulls, long steps */
{14, 17, 1, {0xa134075280a975b4, 0x87a439e72396f6ff}}, /* hulls, long steps */
{14, 16, 7, {0x3ebb369a76007d59, 0x2e95ffce1cc96bae}}, /* hulls, long steps */
{14, 2, 16, {0xdd121b6d05e36acf, 0x7e46b5aeba4c9cc8}}, /* hulls, long steps */
