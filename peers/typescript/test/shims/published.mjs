// Someone's module with the published API and nothing beyond it.
export {
  assertScientificBoundary,
  checkVersion,
  contractStatus,
  NCP_CONTRACT_HASH,
  NCP_VERSION,
  NcpScientificBoundaryError,
  NcpVersionError,
  NeuroSimClient,
  WebSocketNeuroSim,
} from "../../dist/index.js";
