/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0xe690c15144df4947, 0x75f6ea83f94f61a8}}, /* beach */
{0, 1, 17, {0x0b0a8529a85631bd, 0x920972a2d4430450}}, /* beach */
{0, 17, 1, {0x91b076a87dd56eee, 0x6957decb95b00c01}}, /* beach */
{0, 16, 7, {0x3b0fa20d6c368306, 0x197ddea0ec1a8757}}, /* beach */
{0, 2, 16, {0x745bae2d9f39ceed, 0x30346aea6e28e47f}}, /* beach */
{1, 13, 9, {0xbaf80994497cad8f, 0xdeb814ed416ed332}}, /* dam */
{1, 1, 17, {0xcc4baf758501f23e, 0x8b61178135c26f40}}, /* dam */
{1, 17, 1, {0x980df62082bb5f28, 0xc0a6a0f3d6c59197}}, /* dam */
{1, 16, 7, {0xb151cd0e989cac95, 0xbf589aef3a0adb42}}, /* dam */
{1, 2, 16, {0xa4de7935fc68bb52, 0x316cccbcb2530413}}, /* dam */
{2, 13, 9, {0x0f2bc41480f9aaa2, 0xdd5d48303ee334cb}}, /* flood */
{2, 1, 17, {0x49c2aa75d9e0d7f3, 0x50371d5db650f36d}}, /* flood */
{2, 17, 1, {0x423c672a3e4aa3fd, 0xcd2745d8e9cf84fd}}, /* flood */
{2, 16, 7, {0xa3e3d8d13e80cf7c, 0xc1a28f9948904313}}, /* flood */
{2, 2, 16, {0x97a173e89c24dc0d, 0xf4b2782f1d8518f4}}, /* flood */
{3, 13, 9, {0x8d31681e3a202aad, 0xb8fdd3500e0e3eaf}}, /* weir */
{3, 1, 17, {0x0ada2790caee2487, 0x686ce2749c44bef7}}, /* weir */
{3, 17, 1, {0x412d098b7fbd83e0, 0x079028a3b55c3c9e}}, /* weir */
{3, 16, 7, {0xf90dc8024577aed6, 0xcb82bfe0c2a2950b}}, /* weir */
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
{7, 13, 9, {0x8dff25be3d6b9bf9, 0x01e16ad5c5b7682d}}, /* river */
{7, 1, 17, {0x0bf022df59761559, 0x2fe2b547ac76b05f}}, /* river */
{7, 17, 1, {0x52df525ae3fc50cc, 0x7466fbc4abc7b6e6}}, /* river */
{7, 16, 7, {0x8ed1d0289ccae64a, 0x7c392939ae822cc7}}, /* river */
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
{10, 13, 9, {0xaeddcb273eede8d9, 0x9be9490bc58b8fb4}}, /* fed */
{10, 1, 17, {0x1988f01ff8e94dcd, 0x81a1b446723eedc4}}, /* fed */
{10, 17, 1, {0x065a37bd0df536f7, 0x00e6761dc0f88129}}, /* fed */
{10, 16, 7, {0x00f926383e7dfbbc, 0x41a03a57f2291231}}, /* fed */
{10, 2, 16, {0x6beedaad88075838, 0xc8d3e2331a1301dd}}, /* fed */
{11, 13, 9, {0x1c79208109ab8ac4, 0xd6d3e18a3b1adccc}}, /* everything */
{11, 1, 17, {0x5b2566d68f791db5, 0xda40f4492fee7fe3}}, /* everything */
{11, 17, 1, {0x31f154e58a426f31, 0xddbc1f1300051450}}, /* everything */
{11, 16, 7, {0x427c4e63db48d3f4, 0x9b5d969312b01ede}}, /* everything */
{11, 2, 16, {0x975321c235d906e3, 0x2fbc75a505e0d791}}, /* everything */
{12, 13, 9, {0xfbfcb01a45b8f443, 0x35a619f58189d357}}, /* everything, long steps */
{12, 1, 17, {0x27fc469269520656, 0xa8870a195e046a5f}}, /* everything, long steps */
{12, 17, 1, {0x3f7e127be77e33af, 0x292f03f0a4a09772}}, /* everything, long steps */
{12, 16, 7, {0x594feb91c7a23a4b, 0x5c06d05c24eb4d4a}}, /* everything, long steps */
{12, 2, 16, {0x76f3d8481810d4f1, 0x8e38766c1801e5a9}}, /* everything, long steps */
{13, 13, 9, {0xb90cecafcf7391b9, 0x85930df45eeb4c5a}}, /* hulls */
{13, 1, 17, {0xefc6e6dfd02ac6c0, 0x2c836ce9d7cf0f75}}, /* hulls */
{13, 17, 1, {0x89dc749364423a7b, 0x482c7da828a2f3be}}, /* hulls */
{13, 16, 7, {0x1ae81492f3b14a89, 0x31cf8fa74ef2132e}}, /* hulls */
{13, 2, 16, {0x4bf630ac44bf6a77, 0x6d917b54b6a5f657}}, /* hulls */
{14, 13, 9, {0x1578ebcef9ee5d29, 0x5117951619a9f81f}}, /* hulls, long steps */
{14, 1, 17, {0xdeb08cd61c95e1b1, 0xb76e7fb6bd52a292}}, /* hulls, long steps */
{14, 17, 1, {0xced99c7848ea8f29, 0x973d2c8ae4c33f93}}, /* hulls, long steps */
{14, 16, 7, {0xc6558c678b211f1b, 0x159f03fd17c4fff6}}, /* hulls, long steps */
{14, 2, 16, {0xa937db203de2e3ec, 0xeb3c081408a7a216}}, /* hulls, long steps */
