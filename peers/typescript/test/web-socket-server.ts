import { once } from "node:events";
import type { AddressInfo } from "node:net";
import { ReferenceBackend, SessionService } from "@ncp-conformance/peer";
import { WebSocketServer, type WebSocket } from "ws";

/** What a server does with a request: whatever it likes with the connection over which it came. */
export type Behaviour = (request: string, socket: WebSocket, server: TestServer) => void;

/** A session service on a port of its own, whose manners can be changed while it runs. */
export class TestServer {
  readonly service = new SessionService(new ReferenceBackend());
  /** The requests that came, in their order. */
  readonly requests: string[] = [];
  /** How many connections were made. */
  connections = 0;
  behave: Behaviour = answer;
  readonly port: number;
  readonly #server: WebSocketServer;

  private constructor(server: WebSocketServer) {
    this.#server = server;
    this.port = (server.address() as AddressInfo).port;
    server.on("connection", (socket) => {
      this.connections += 1;
      socket.on("error", () => {});
      socket.on("message", (data) => {
        const request = String(data);
        this.requests.push(request);
        this.behave(request, socket, this);
      });
    });
  }

  /** @param port - 0: any that is free */
  static async start(port = 0): Promise<TestServer> {
    const server = new WebSocketServer({ port, host: "127.0.0.1" });
    await once(server, "listening");
    return new TestServer(server);
  }

  get url(): string {
    return `ws://127.0.0.1:${this.port}`;
  }

  /** Ends all connections at once, as a crash would. */
  cut(): void {
    for (const socket of this.#server.clients) socket.terminate();
  }

  async stop(): Promise<void> {
    this.cut();
    this.#server.close();
    await once(this.#server, "close");
  }
}

/** What a server should do. */
export function answer(request: string, socket: WebSocket, server: TestServer): void {
  socket.send(server.service.handle(request));
}
