// Finds the program in the package of this platform.
import { createRequire } from "node:module";

const require = createRequire(import.meta.url);

/** The path of the program ncp-verify. */
export function program() {
  const platform = `${process.platform}-${process.arch}`;
  const name = `@ncp-verify/${platform}`;
  const file = process.platform === "win32" ? "ncp-verify.exe" : "ncp-verify";
  try {
    return require.resolve(`${name}/bin/${file}`);
  } catch {
    throw new Error(
      `the package ${name} is not installed: npm leaves it out with --omit=optional, or where a lock file is of ` +
        `another platform; without one for ${platform}, build the program by cargo install`,
    );
  }
}
