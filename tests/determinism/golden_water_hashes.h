/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0x40c77639bb4f9550, 0x740d034c578381b3}}, /* beach */
{0, 1, 17, {0xaae71d8a3356e11e, 0x3722ec198108f678}}, /* beach */
{0, 17, 1, {0x3a7219fe99747664, 0x9a9c447dd90c735f}}, /* beach */
{0, 16, 7, {0xbabc423129dc5fe0, 0x039614e48f43073d}}, /* beach */
{0, 2, 16, {0x17d868f59b399b1c, 0x91b1bb4236b0b005}}, /* beach */
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
{3, 13, 9, {0x3b418dc898f82c54, 0x65bab7662ba45878}}, /* coupled */
{3, 1, 17, {0x5c58421e823a19ab, 0xd0f14b4e62a891c5}}, /* coupled */
{3, 17, 1, {0x2e54db8fd457f0cc, 0x05e4c7cf8f8324b3}}, /* coupled */
{3, 16, 7, {0x8c9bd5a2f90b1b89, 0xda07ec8a3c2b3893}}, /* coupled */
{3, 2, 16, {0x4a7a8401f8da91e2, 0x82ac11791f5fcc0a}}, /* coupled */
{4, 13, 9, {0x25f6c85096635e04, 0x109fdbb454ec46c9}}, /* coupled, advected */
{4, 1, 17, {0x22cf3b67d77845f6, 0x604d3d2b91ec3698}}, /* coupled, advected */
{4, 17, 1, {0x50345479e401964b, 0xd3f3c40ddb2e2614}}, /* coupled, advected */
{4, 16, 7, {0x99d99001a259a845, 0xe7b3093de1d9ca58}}, /* coupled, advected */
{4, 2, 16, {0xad6fa8e9db53a957, 0x037549e5b954cefe}}, /* coupled, advected */
{5, 13, 9, {0x6735f99f747d26c6, 0x36b5f35b5f5473d6}}, /* explicit */
{5, 1, 17, {0x9f7b5526b245474e, 0x00ca7bcf66f4ac98}}, /* explicit */
{5, 17, 1, {0x6b8c1e86e16159fd, 0xb6c2ea5bc13020f7}}, /* explicit */
{5, 16, 7, {0x4e1e4ff239dd35ca, 0xdab071ee7f442472}}, /* explicit */
{5, 2, 16, {0xa6e6790e06565a5a, 0xe2717004a897b4f2}}, /* explicit */
{6, 13, 9, {0x35bf0059b3db77b1, 0x7b2a5e2cb981b972}}, /* forward */
{6, 1, 17, {0x6b9ed68bc83dda7b, 0xb834c23b6304cfa7}}, /* forward */
{6, 17, 1, {0xc1f0dc0f0b8a006d, 0x9852970dc04e34a3}}, /* forward */
{6, 16, 7, {0x990590820a1d102e, 0xc25ccb156a01b079}}, /* forward */
{6, 2, 16, {0xa698f90a88ab98fd, 0x6e1245d680165b2c}}, /* forward */
{7, 13, 9, {0xfded0cc92f6aa2eb, 0x8bc4b030eb5d24c0}}, /* tide */
{7, 1, 17, {0xd1af62a482527ccc, 0xc20c8667f3c4ad13}}, /* tide */
{7, 17, 1, {0x92d1db448f1fe831, 0xa302b5825608e49a}}, /* tide */
{7, 16, 7, {0x1ce8cd58f8100286, 0xbb8850a175db8a8c}}, /* tide */
{7, 2, 16, {0x481da7063371fb9c, 0x2fab1ebfbffb21dc}}, /* tide */
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
{10, 13, 9, {0xd8571992e5bd463a, 0x02c4b9e889904949}}, /* masked */
{10, 1, 17, {0x7a2ded47e5747511, 0x2a10cc4bec985ffa}}, /* masked */
{10, 17, 1, {0x0c56fa59df9a6ad8, 0x791c0aa86ca21b50}}, /* masked */
{10, 16, 7, {0x89e32995904db5ba, 0x912536f0943ab7c1}}, /* masked */
{10, 2, 16, {0xdb8cb2e15fb27ade, 0xda690149e184f25a}}, /* masked */
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
