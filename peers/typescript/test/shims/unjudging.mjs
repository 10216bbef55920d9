// As published, but its client hands back whatever comes, and its version guard stumbles.
export { contractStatus, NCP_CONTRACT_HASH, NCP_VERSION } from "../../dist/index.js";

export function checkVersion(version) {
  return version.nothing.here;
}

export class NeuroSimClient {
  constructor(send) {
    this.open = this.step = this.run = async (request) => send(JSON.stringify(request));
    this.close = async (session_id) => send(JSON.stringify({ kind: "close_session", session_id }));
  }
}
