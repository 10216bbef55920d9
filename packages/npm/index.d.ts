/** The path of the program ncp-verify; throws where the package of this platform is not installed. */
export function program(): string;
