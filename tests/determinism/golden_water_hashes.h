/* Printed by test_water_golden.c: scene, cells along x and y, {float32, float64}. */
{0, 13, 9, {0xa8431ef69e5e5eac, 0x4c9985200f0d9233}}, /* beach */
{0, 1, 17, {0x22557650a7707914, 0xfe769948f135a155}}, /* beach */
{0, 17, 1, {0xa21d05c75d6d9a82, 0xa8a02f3edad30b29}}, /* beach */
{0, 16, 7, {0x67b71c7066b224ff, 0x70d9ea4f60b7ae3f}}, /* beach */
{0, 2, 16, {0xd618bfe5960a7bbb, 0xa273b151f1bae12b}}, /* beach */
{1, 13, 9, {0x08628f3d6ef53c21, 0xa230078a906436b3}}, /* dam */
{1, 1, 17, {0x88341f72647985d9, 0x92821ba5f68e95b9}}, /* dam */
{1, 17, 1, {0xcfd259813dd131aa, 0xe6a91783a45dead5}}, /* dam */
{1, 16, 7, {0xc04cddfd6e44f8a8, 0x74d198385362c6f3}}, /* dam */
{1, 2, 16, {0x1fa3f5598cca591c, 0xaa006afc6bab035d}}, /* dam */
{2, 13, 9, {0x9a9c4e1521101a10, 0xc46aed6fc3c9b434}}, /* flood */
{2, 1, 17, {0xd5f2d33161874988, 0x2463c3ec692f322b}}, /* flood */
{2, 17, 1, {0x87b4919cf43297c8, 0x853f51fbbd6e7292}}, /* flood */
{2, 16, 7, {0xbe986ef8ce279e0a, 0xb05da218a8dfc0ef}}, /* flood */
{2, 2, 16, {0x8ab9826b2ca8a1ea, 0x28084be318f74163}}, /* flood */
{3, 13, 9, {0x6f3bc59647ec5125, 0x3ccdea6e209f41c6}}, /* coupled */
{3, 1, 17, {0x798fd8e226aad56b, 0xc6dd9580dc9197a4}}, /* coupled */
{3, 17, 1, {0x05fc4ea8219bface, 0x516c35b58ea31d82}}, /* coupled */
{3, 16, 7, {0x2cfe34ac5eec62cf, 0xd919c9d695363d7d}}, /* coupled */
{3, 2, 16, {0x7b5d216d545e32b0, 0xf8de3bd41d591ed6}}, /* coupled */
{4, 13, 9, {0x19659d357bab4167, 0x3ec0dd8a0606dfee}}, /* coupled, advected */
{4, 1, 17, {0xefbd1b382c40eb25, 0x65a174a460a78c36}}, /* coupled, advected */
{4, 17, 1, {0x886a8241fe45723a, 0xb2cc4194fa72f94e}}, /* coupled, advected */
{4, 16, 7, {0xf5bc029a2a3a0dfb, 0x4de70da377aa9c19}}, /* coupled, advected */
{4, 2, 16, {0x26ff6dc6d5b34df8, 0xdf7330bb0230fd32}}, /* coupled, advected */
{5, 13, 9, {0x903ec049640ee45b, 0x6acd7480af39c1bf}}, /* explicit */
{5, 1, 17, {0x018954743d60efd2, 0x6c5984d1366f012a}}, /* explicit */
{5, 17, 1, {0xe690cea379de466e, 0xf37acd34af9f0478}}, /* explicit */
{5, 16, 7, {0xe4507306a7c667c5, 0xdc2bac6de7629103}}, /* explicit */
{5, 2, 16, {0x85d88cc7e7faeab6, 0xa6d255961a40baca}}, /* explicit */
{6, 13, 9, {0x3a5f0b72d0df4d61, 0x668f650ddc9c5a16}}, /* forward */
{6, 1, 17, {0x73e0263b0c300a01, 0x875173af29e73e97}}, /* forward */
{6, 17, 1, {0x0cc6a528235d039d, 0x41bf44197de7885e}}, /* forward */
{6, 16, 7, {0x1aabafa5d7a91b9f, 0x89051dceaa9ec6ac}}, /* forward */
{6, 2, 16, {0x356441ec03349452, 0x66af0de1f9fb2791}}, /* forward */
{7, 13, 9, {0x19eaa8403716fe0b, 0xe6735b91b051866f}}, /* tide */
{7, 1, 17, {0x4701924f40b9686e, 0x8dbab2d48b87d419}}, /* tide */
{7, 17, 1, {0x426bd570f77fd3c8, 0x9c6aaf52dcf8e0e8}}, /* tide */
{7, 16, 7, {0x1020c2e5b2be70fc, 0x907333948faa2355}}, /* tide */
{7, 2, 16, {0x79adc20509d6b359, 0x241cba492c8b6954}}, /* tide */
{8, 13, 9, {0xbac5cbe5cc263b0f, 0x0a376b161527ac28}}, /* river */
{8, 1, 17, {0x709d66eddaf0b1a4, 0x0831a6ab4bf77afb}}, /* river */
{8, 17, 1, {0xb155b9ed3bc3ccdd, 0xd55a4d3497b3b288}}, /* river */
{8, 16, 7, {0x0ad1c89c108bc61d, 0x350cd7627f8ed7a0}}, /* river */
{8, 2, 16, {0xb5af4ee3fdb3dfa4, 0xc6511228586eabb3}}, /* river */
{9, 13, 9, {0x644e289ae36b86d4, 0x5c45fa80fc7c2b41}}, /* torus */
{9, 1, 17, {0x3e2bd7cd1976a460, 0x0a55d8e1e5d8382f}}, /* torus */
{9, 17, 1, {0x8a31d22521c236a7, 0xaf981787110e622b}}, /* torus */
{9, 16, 7, {0xe496bb4cae2a0c36, 0xe9eac246ed39a7c0}}, /* torus */
{9, 2, 16, {0x82adb15e554953fa, 0x9396cbb36fa959cf}}, /* torus */
{10, 13, 9, {0x9db062a299ff6113, 0x8eaae7afba38c525}}, /* masked */
{10, 1, 17, {0x540906991129215b, 0xc9b2170ccf5b1cbd}}, /* masked */
{10, 17, 1, {0xd1930fc623f587a6, 0xcf9e66c1fe8c4e5f}}, /* masked */
{10, 16, 7, {0xca1324d2682113a4, 0xde4f96126f5224f1}}, /* masked */
{10, 2, 16, {0xfb68608aad196062, 0xc42d27e79b853a16}}, /* masked */
{11, 13, 9, {0x92f32cab51e5e6bc, 0x79b5fe74b61d7e34}}, /* fed */
{11, 1, 17, {0x8311c49f761a9884, 0xf645b15456187a73}}, /* fed */
{11, 17, 1, {0xb49c5da940634d3b, 0x2ce5692190f751c3}}, /* fed */
{11, 16, 7, {0xc7c434003e2dd180, 0x668a1eb13b61c79a}}, /* fed */
{11, 2, 16, {0x6b3812828372aba8, 0x0e2a86146326657c}}, /* fed */
{12, 13, 9, {0x484d3779540becef, 0xd88e8392bb3e8c7d}}, /* everything */
{12, 1, 17, {0x18d4b79a496325a0, 0x8fc36e2b63904131}}, /* everything */
{12, 17, 1, {0x7b4b3fb3781f3699, 0xf5baa5a10b5a080a}}, /* everything */
{12, 16, 7, {0x2d6d400ed1be4591, 0xac0ff08902695f19}}, /* everything */
{12, 2, 16, {0x5e121513d2ed84fe, 0xac859dcdcd6fa594}}, /* everything */
{13, 13, 9, {0x91e9e3d9c130293b, 0x360fca1f7e6782b2}}, /* everything, large steps */
{13, 1, 17, {0xd7e610a00ace7979, 0xdd124040e6c712d0}}, /* everything, large steps */
{13, 17, 1, {0xc61030336cd11ee0, 0xe169742e9b960ed0}}, /* everything, large steps */
{13, 16, 7, {0xd8154bd5f78c8e13, 0xf66350c4b2f19089}}, /* everything, large steps */
{13, 2, 16, {0x463e5c3baf962ec3, 0x6b66ee4665760273}}, /* everything, large steps */
{14, 13, 9, {0xaa3d38d630753206, 0x648da175dde23be9}}, /* everything, coupled */
{14, 1, 17, {0x35deb650ee2b7e6f, 0x816383a44c258082}}, /* everything, coupled */
{14, 17, 1, {0xee6763b85c807677, 0x32fdcbe166462cec}}, /* everything, coupled */
{14, 16, 7, {0x7d6dc6e0f654421c, 0x5d923b300d5f6035}}, /* everything, coupled */
{14, 2, 16, {0x0971d348d3f04bb6, 0xefa5b416488749c0}}, /* everything, coupled */
