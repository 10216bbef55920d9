/** The path of the program ncp-verify, or what NCP_VERIFY names; throws where the package of this platform is not installed. */
export function program(): string;
