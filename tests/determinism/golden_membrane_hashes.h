/* Printed by test_membrane_golden.c: scene, method, solver, {float32, float64}. */
{0, 0, 0, {0x800bbd483f67c44a, 0x2c4d86941f96e144}}, /* drum */
{0, 1, 0, {0x12703e5684a333d0, 0x4241c5d8158f445f}}, /* drum */
{0, 2, 0, {0x0f4bf319ab1256f2, 0xbef7fd62e239a030}}, /* drum */
{0, 3, 0, {0xa7a4463f4cad5c7a, 0x4be95e5f2adc83f9}}, /* drum */
{0, 0, 1, {0xd47d00385974bb0e, 0xc64e954d27bb982f}}, /* drum */
{0, 3, 1, {0xbdf0ef636bcf205e, 0x1187194efc26663b}}, /* drum */
{1, 0, 0, {0xb046f38353bde6f4, 0x3fa0f41a08dd4a60}}, /* curtain */
{1, 1, 0, {0x0eed559c3549a2ea, 0x13de0283d04fb96f}}, /* curtain */
{1, 2, 0, {0xf69971f077716d25, 0x5ef85df938b0aaa9}}, /* curtain */
{1, 3, 0, {0xbfee793fdb934e65, 0x31d39c3ee3353d0f}}, /* curtain */
{1, 0, 1, {0x8628636a7793fe90, 0x79c22ad8a2dd5292}}, /* curtain */
{1, 3, 1, {0xf43ddb81193da0b6, 0xd618ea758a77bfed}}, /* curtain */
{2, 0, 0, {0xc88c35d792a5e0a1, 0xbd69f39f71ae0fcd}}, /* flag */
{2, 1, 0, {0xe5a88bd0d32c7faa, 0xe3d2df33f8ec01ab}}, /* flag */
{2, 2, 0, {0xeec52f2840e0bac0, 0x75ab4c5d80670fc9}}, /* flag */
{2, 3, 0, {0x3cd2410beb61bb08, 0x71c8b76095346323}}, /* flag */
{2, 0, 1, {0x9fb8e48ae944014c, 0xea47e75fd943e08b}}, /* flag */
{2, 3, 1, {0x6d9eec69ef652e10, 0xf2a7646e3ff263cd}}, /* flag */
{3, 0, 0, {0x04d2792853ab7b57, 0x97f58f67dcdb32d8}}, /* plate */
{3, 1, 0, {0xea85fea299701f04, 0xe5dc292e76cd287a}}, /* plate */
{3, 2, 0, {0x85ead6767913d304, 0x67efd6c8c1531f3f}}, /* plate */
{3, 3, 0, {0x2a84ce77ee889810, 0xd5a82982fcf1fec9}}, /* plate */
{3, 0, 1, {0xbb8aee28be501bd9, 0xc94854a87dcd8bfa}}, /* plate */
{3, 3, 1, {0x55afa0f429205b46, 0x9b1763e3e7e96711}}, /* plate */
{4, 0, 0, {0x0031f91666abe52f, 0xc6642a1695d2f564}}, /* tube */
{4, 1, 0, {0xa3ed2edc69e7b6f7, 0x0c4f61c0a2297fea}}, /* tube */
{4, 2, 0, {0x346313534836d27c, 0x9caf93e0ad468686}}, /* tube */
{4, 3, 0, {0x31143eca0409760c, 0x33f8d32d9e25c2e7}}, /* tube */
{4, 0, 1, {0x90e4474e39b801a4, 0x959c57f1f08eadba}}, /* tube */
{4, 3, 1, {0xc4dc688506f57838, 0xc9b36eea3290d05f}}, /* tube */
{5, 0, 0, {0x128a8930ab03d4ee, 0x8085226491d73634}}, /* torus */
{5, 1, 0, {0xb860b65a2d1b5315, 0xa021bf6a1c12d05f}}, /* torus */
{5, 2, 0, {0x33578f39606f4740, 0x67a3c5bc3ccca816}}, /* torus */
{5, 3, 0, {0x909b6e95678b21b8, 0xd59aac492df35cee}}, /* torus */
{5, 0, 1, {0xf2a09f2614062dfc, 0x29b74a663a74deaf}}, /* torus */
{5, 3, 1, {0x016433d611255177, 0x2129b337f9fcc6f1}}, /* torus */
{6, 0, 0, {0x52abf360e5e1f6e2, 0x01c5f1edd76fe067}}, /* torn */
{6, 1, 0, {0xc3ecc9c6c2b19db0, 0x0548acff8057e509}}, /* torn */
{6, 2, 0, {0x096c7eac64bc1cfa, 0x1dbf5909b5f7e258}}, /* torn */
{6, 3, 0, {0xf7b00c8328af8a98, 0xb2cb227fd0549972}}, /* torn */
{6, 0, 1, {0xebfa7a864019019e, 0x9bd3fbb7b393d10c}}, /* torn */
{6, 3, 1, {0x486914f5d826ee19, 0xe2ebb7a2562489db}}, /* torn */
{7, 0, 0, {0xb87fb6c507b8e348, 0x67fa6863b82adf80}}, /* tied */
{7, 1, 0, {0x7a24da4792344fdd, 0xca02ad651d64dbb6}}, /* tied */
{7, 2, 0, {0x3a7a7e355a386344, 0x5a19a91e55a393aa}}, /* tied */
{7, 3, 0, {0xed11029c1d50d6cf, 0x5ab646ed39b75d09}}, /* tied */
{7, 0, 1, {0x6110e37cd0eda1eb, 0xf0374491ca63e03b}}, /* tied */
{7, 3, 1, {0x6e2aee63e899cf41, 0x42a1aefeb95b4ed0}}, /* tied */
{8, 0, 0, {0x2ffe0619e282e2c8, 0xefa4e800e446b7c3}}, /* everything */
{8, 1, 0, {0x3af754ebc287b48f, 0xeece48ebe1d451f5}}, /* everything */
{8, 2, 0, {0x1ad83564a8a1bd2e, 0xd6b1437bc8be1c74}}, /* everything */
{8, 3, 0, {0x8b6cbd35ec388059, 0x4f31239df50f5e7e}}, /* everything */
{8, 0, 1, {0x07011b9ae19be60c, 0x47cbe1948c9cc030}}, /* everything */
{8, 3, 1, {0x686bdfb652a5b995, 0x790d6ea4b12b61f7}}, /* everything */
{9, 0, 0, {0xe8a5ff0b91679182, 0xda629aab1e86f719}}, /* everything, tube */
{9, 1, 0, {0x08a93167d0329b7a, 0x34cf84c253419d23}}, /* everything, tube */
{9, 2, 0, {0x66cfafd6b74572f5, 0xaacea143fc5fdf12}}, /* everything, tube */
{9, 3, 0, {0x3d0fe91e35e3c78f, 0xf875ebadc490f80b}}, /* everything, tube */
{9, 0, 1, {0x531346c2f77db88a, 0xdaf2406c65b1fe9c}}, /* everything, tube */
{9, 3, 1, {0xf5289829d0c361ab, 0xf14f6bf7992a2c4e}}, /* everything, tube */
{10, 0, 0, {0x1b2590e4e1e8ee5b, 0x5572968df3828638}}, /* sail */
{11, 0, 0, {0xb96bffd935056ff1, 0x7809940e1b8e4697}}, /* lengths */
{12, 0, 0, {0x7aa1f6b48b0fb7e5, 0xfcad842cdf628287}}, /* lengths, tube */
