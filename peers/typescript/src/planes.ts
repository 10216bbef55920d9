/**
 * The four planes and the quality of service of each (chapter 3.1).
 *
 * @module
 */

/** A plane: one kind of traffic. */
export type Plane = "control" | "perception" | "action" | "observation";

/** How the publisher of a plane sends, in Zenoh's terms. */
export interface Qos {
  /** What a full queue does: `block` waits, `drop` loses a frame. */
  readonly congestion: "block" | "drop";
  readonly priority: "Data" | "DataHigh" | "RealTime";
  /** Whether a frame is sent at once, without batching. */
  readonly express: boolean;
}

/** The quality of service of every plane. */
export const PLANES: Readonly<Record<Plane, Qos>> = Object.freeze({
  control: Object.freeze({ congestion: "block", priority: "Data", express: false }), // [NCP-PLANE-001]
  perception: Object.freeze({ congestion: "drop", priority: "DataHigh", express: false }), // [NCP-PLANE-002]
  action: Object.freeze({ congestion: "drop", priority: "RealTime", express: true }), // [NCP-PLANE-003]
  observation: Object.freeze({ congestion: "block", priority: "Data", express: false }), // [NCP-PLANE-004]
});
