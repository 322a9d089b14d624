/* Printed by test_golden.c: scene, method, {float32, float64}. */
{0, 0, {0xcaefb6fd3d8c98e9, 0xd89be9c350896b4a}}, /* rope */
{0, 1, {0x094d2938ce655c07, 0x2c834541fcdca0bc}}, /* rope */
{0, 2, {0xfb662c0ec88ef420, 0xb61f94fcb20a4fc6}}, /* rope */
{0, 3, {0xfd831064b3df4329, 0x6d3360fb6cef4f56}}, /* rope */
{1, 0, {0xa52a5c05b918268a, 0xa250e9bbd1462699}}, /* net */
{1, 1, {0xf5ee84623c758f6d, 0xa4c9905f4abe432b}}, /* net */
{1, 2, {0x1762f7121c12f1b0, 0xbc959129fd37e12d}}, /* net */
{1, 3, {0x2f8ef9c41ecac99a, 0x8081d49a2f66ece3}}, /* net */
{2, 0, {0x3b22b5ab85c997c7, 0x5bd1d71291cc0b7e}}, /* hair */
{2, 1, {0x122347d93959e6f2, 0xde302fcbdd45ebf3}}, /* hair */
{2, 2, {0x25cbb89e2d2dbc14, 0x8492b3d5c39bbd49}}, /* hair */
{2, 3, {0x9d2fd343770d00b6, 0x7638b6fffc5fea12}}, /* hair */
{3, 0, {0xe13edb8a3a9e09a8, 0x7b5a30af27b4b558}}, /* ring */
{3, 1, {0x2d90cdee0768eb0f, 0x80c0ab3d927edd9e}}, /* ring */
{3, 2, {0xc59e7be4f9a78716, 0xf719a6b86ba0681e}}, /* ring */
{3, 3, {0xfbd0b70c09deca82, 0x1c2e859a8c014baa}}, /* ring */
{4, 0, {0x780bd771b31591f7, 0x2244b177cef3a483}}, /* bent ring */
{4, 1, {0x122d95581aa5463b, 0x2536f0c5b335a10d}}, /* bent ring */
{4, 2, {0xbbbc4d40791f2eb7, 0x417fcf8b82a2afb2}}, /* bent ring */
{4, 3, {0x7cbb411abc49cf97, 0x914011faa6d21b05}}, /* bent ring */
{5, 0, {0x8f0d1019d085e030, 0xa3cfa4fd1606be68}}, /* welded */
{5, 1, {0x4ed2ed182bdde063, 0x101d10ee5cbb104e}}, /* welded */
{5, 2, {0x44e2c8f4309b22c6, 0x415fd4bfc91c39d2}}, /* welded */
{5, 3, {0x6fbceec74be409f0, 0xb9e6e8f908673a1b}}, /* welded */
{6, 0, {0x98f4fb49a76f924e, 0xb9c252357a592eba}}, /* attached */
{6, 1, {0xcfee776564df6e49, 0x2ad9ee8e4d358eb5}}, /* attached */
{6, 2, {0x1d3f55952a4ba503, 0x2da84d98d9c94907}}, /* attached */
{6, 3, {0x02e74e42d8782d37, 0x5f1d74fca9ca9ec9}}, /* attached */
{7, 0, {0xb52631e404f0c646, 0xa0abe251c1b9fadf}}, /* driven */
{7, 1, {0x0c1373ffde894937, 0x6fb3447173149088}}, /* driven */
{7, 2, {0x7496f3d017d6a0ed, 0x50c9144e987064a3}}, /* driven */
{7, 3, {0x24c35f9070653a54, 0x8a5cd73254b93442}}, /* driven */
{8, 0, {0xf9282ddfd5d0ad3d, 0x5ef28fa85d8c7431}}, /* everything */
{8, 1, {0xe0ba5941520b0224, 0xc1b9d96db4a1704c}}, /* everything */
{8, 2, {0x148d8df4f7de64f1, 0xbf0932e5b3212223}}, /* everything */
{8, 3, {0xb142c17ee2440e1b, 0x4f837355ac9c4814}}, /* everything */
{9, 0, {0x83cd7b941992f620, 0x9205d4c1229c480a}}, /* everything, ring */
{9, 1, {0xd0fdfae345a8618d, 0x4aecdff4d26ad7ba}}, /* everything, ring */
{9, 2, {0xa445c4cd5ff2bd37, 0xb8b76985b29e59f6}}, /* everything, ring */
{9, 3, {0x25a57b8a9d833e69, 0xf800f6d9eaa8593e}}, /* everything, ring */
