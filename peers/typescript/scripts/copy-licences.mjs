// Puts the licences of the project beside the package, which is where npm takes them from.

import { copyFileSync } from "node:fs";

for (const licence of ["LICENSE-APACHE", "LICENSE-MIT"]) {
  copyFileSync(new URL(`../../../${licence}`, import.meta.url), new URL(`../${licence}`, import.meta.url));
}
