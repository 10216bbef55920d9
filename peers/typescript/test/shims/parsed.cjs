// As published, but over a bus that parses: its Send takes and gives objects, `close` takes the whole request, and
// errors are plain. What it prints is no answer.
const { NeuroSimClient: Inner, ...ncp } = require("../../dist/cjs/index.js");

console.log("imported");

class NeuroSimClient {
  #inner;

  constructor(send) {
    this.#inner = new Inner(async (text) => JSON.stringify(await send(JSON.parse(text))));
    for (const name of ["open", "step", "run"]) this[name] = (request) => this.#plain(this.#inner[name](request));
  }

  close(request) {
    return this.#plain(this.#inner.close(request.session_id));
  }

  async #plain(outcome) {
    console.log("asked");
    try {
      return await outcome;
    } catch (error) {
      throw new Error(error.message);
    }
  }
}

const { NCP_VERSION, NCP_CONTRACT_HASH, checkVersion, contractStatus } = ncp;
module.exports = { NCP_VERSION, NCP_CONTRACT_HASH, checkVersion, contractStatus, NeuroSimClient };
