// Tells Node and the compiler that the files of dist/cjs are CommonJS, unlike the rest of the package.

import { writeFileSync } from "node:fs";

writeFileSync(new URL("../dist/cjs/package.json", import.meta.url), '{ "type": "commonjs" }\n');
