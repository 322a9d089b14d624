/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0xf8857b11e89d2b15, 0x7820ec6ab082bedd}}, /* beach */
{0, 1, 17, {0xaae71d8a3356e11e, 0x3722ec198108f678}}, /* beach */
{0, 17, 1, {0x0e39abe19b7879f3, 0xa47d51adb49fee25}}, /* beach */
{0, 16, 7, {0x75a0dc56fe938c3b, 0xb76886e36d130757}}, /* beach */
{0, 2, 16, {0x3c869512f5872370, 0xbe688ad6d6b416b0}}, /* beach */
{1, 13, 9, {0x2f60b716057551d9, 0xe6712e1392e98aca}}, /* dam */
{1, 1, 17, {0xe8a2b0f406a37377, 0x26d92085c6a9835f}}, /* dam */
{1, 17, 1, {0x0fae0f5ae9a83a62, 0x2c33cee196d352aa}}, /* dam */
{1, 16, 7, {0x9e0b2a164b5919bc, 0x16ab805fded1515c}}, /* dam */
{1, 2, 16, {0x2c6ddc7ed508dd94, 0xfba3ddd31fc445b0}}, /* dam */
{2, 13, 9, {0x745e4e06bb91b0c4, 0x18a11fd78b9d68e9}}, /* flood */
{2, 1, 17, {0x264f16f6d063701a, 0xb95912c5c5a90fca}}, /* flood */
{2, 17, 1, {0x87b4919cf43297c8, 0x853f51fbbd6e7292}}, /* flood */
{2, 16, 7, {0x06809cf470854840, 0xa60e986fd4c0050d}}, /* flood */
{2, 2, 16, {0x2166d4c5f3f61d8e, 0xc38d0cd6ab4cd8a4}}, /* flood */
{3, 13, 9, {0x267cf267e9224123, 0x1c8eb6a00154717c}}, /* coupled */
{3, 1, 17, {0x5c58421e823a19ab, 0xd0f14b4e62a891c5}}, /* coupled */
{3, 17, 1, {0x9a5ed2bcd33c8aaa, 0xdafee58e42d3fdfd}}, /* coupled */
{3, 16, 7, {0xb597e54e697f151a, 0xdf0c1de4ed194f97}}, /* coupled */
{3, 2, 16, {0x75e6c95d6a179f6e, 0x052d23f8966549a5}}, /* coupled */
{4, 13, 9, {0x25f6c85096635e04, 0x109fdbb454ec46c9}}, /* coupled, advected */
{4, 1, 17, {0x22cf3b67d77845f6, 0x604d3d2b91ec3698}}, /* coupled, advected */
{4, 17, 1, {0x50345479e401964b, 0xd3f3c40ddb2e2614}}, /* coupled, advected */
{4, 16, 7, {0x99d99001a259a845, 0xe7b3093de1d9ca58}}, /* coupled, advected */
{4, 2, 16, {0xad6fa8e9db53a957, 0x037549e5b954cefe}}, /* coupled, advected */
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
{8, 13, 9, {0x5508ff805bfa46ab, 0x2af33a4bc639a9b8}}, /* river */
{8, 1, 17, {0x271678daea4b8910, 0x49f9922e74d13b3c}}, /* river */
{8, 17, 1, {0xf381e19295ed93c8, 0x68ca373b66a12d01}}, /* river */
{8, 16, 7, {0xf77f2c936501e803, 0xe321e16314f353f2}}, /* river */
{8, 2, 16, {0x7ffd27e108c3b14e, 0x33dbe7502c38851f}}, /* river */
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
{11, 13, 9, {0x83f7d54708941936, 0xecd65de27847cef7}}, /* fed */
{11, 1, 17, {0x8c27bb51acc2f15e, 0xf31f218ba57affcb}}, /* fed */
{11, 17, 1, {0x65a893a125244b0a, 0xe40899dae38d9d0b}}, /* fed */
{11, 16, 7, {0x79f26e7bcd91fd2d, 0xf942c60cef9bea4e}}, /* fed */
{11, 2, 16, {0x157e36c8c760a9ad, 0xb9fd126bb8801c35}}, /* fed */
{12, 13, 9, {0xe498d4be2d9256f3, 0x7aa6fe80a2af1653}}, /* everything */
{12, 1, 17, {0x9c50f54440557269, 0xfeda4329d94b5569}}, /* everything */
{12, 17, 1, {0x22897bd677237212, 0x5bffc639c816e8eb}}, /* everything */
{12, 16, 7, {0x7a1093c547e773a4, 0x11f64e49795dc4c7}}, /* everything */
{12, 2, 16, {0x91b5b2aaaefa637a, 0x7dd06bbb988d2f00}}, /* everything */
{13, 13, 9, {0xfb67f2feb6cc6177, 0xc0fe51baa301df25}}, /* everything, large steps */
{13, 1, 17, {0xca67a8bbe7fdc9ec, 0x58f511f7dcfa569a}}, /* everything, large steps */
{13, 17, 1, {0x7ffa921700bce2d4, 0x2ee15cf27baac901}}, /* everything, large steps */
{13, 16, 7, {0x9e2b1d2f9128e7d9, 0xd73927d9043c608f}}, /* everything, large steps */
{13, 2, 16, {0x3600aaa2ac8350c7, 0xf102114941e27f18}}, /* everything, large steps */
{14, 13, 9, {0xf2b6da42f29dc0a8, 0x015d384cfd76d9bb}}, /* everything, coupled */
{14, 1, 17, {0x4d7396dc4243b54b, 0x4dd3363c73346a09}}, /* everything, coupled */
{14, 17, 1, {0x1b82ae4820afdbfa, 0xc81dfe26f0221f0d}}, /* everything, coupled */
{14, 16, 7, {0xb10c01c34785beaf, 0xd289b0aebe00e3f0}}, /* everything, coupled */
{14, 2, 16, {0x2e785c40c3bfdea3, 0x338eddb183497741}}, /* everything, coupled */
