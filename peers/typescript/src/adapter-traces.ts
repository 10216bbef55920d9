/**
 * The calls of the peer protocol whose objects have a state: each builds one, does the steps, and answers for each.
 *
 * @module
 */

import { ActionBuffer, maxHorizonLen } from "./action-buffer.js";
import {
  doubleIn,
  doubleOrNullIn,
  doubleOut,
  frameIn,
  integerIn,
  isObject,
  listIn,
  mapOut,
  messageIn,
  messageOrNullIn,
  messageOut,
  Refusal,
  refusalOut,
  strictIn,
  textIn,
  textOrNullIn,
  type Args,
  type Call,
  type Json,
} from "./adapter-values.js";
import { ControlLoop } from "./control-loop.js";
import { SafetyGovernor } from "./governor.js";
import { LinkMonitor } from "./link-monitor.js";
import type { ChannelValue, CommandFrame, ControlStatus, Mode, SafetyLimits } from "./messages.js";
import { RateCodec, UAV_CODEC, type DecoderMapping, type Range } from "./rate-codec.js";
import { ReferenceBackend } from "./reference-backend.js";
import { ReflexController, type ReflexConfig } from "./reflex.js";
import type { RequestKind } from "./requests.js";
import { SessionService } from "./session-service.js";
import { CommandWatchdog } from "./watchdog.js";

/** The calls by name, in the order of the protocol's page. */
export const TRACES: readonly (readonly [string, Call])[] = [
  [
    "governor.run",
    (args) => {
      const { capabilities } = args;
      const channels = isObject(capabilities)
        ? messageIn("capabilities", {
            controller_id: "",
            sensor_channels: capabilities["sensor_channels"] ?? [],
            command_channels: capabilities["command_channels"] ?? [],
          })
        : null;
      const governor = new SafetyGovernor(limitsIn(args), channels);
      return trace(args, {
        govern: (step) => {
          const command = messageIn("command_frame", step["command"]);
          const sensor = messageOrNullIn("sensor_frame", step["sensor"]);
          const lastSensorS = doubleOrNullIn(step["last_sensor_s"]);
          return { frame: messageOut(governor.govern(command, doubleIn(step["now_s"]), sensor, lastSensorS)) };
        },
        note_link: (step) => done(governor.noteLink(step["burst"] === true)),
        reset: () => done(governor.reset()),
      });
    },
  ],
  [
    "watchdog.run",
    (args) => {
      const watchdog = new CommandWatchdog();
      return trace(args, {
        command: (step) =>
          done(watchdog.onCommand(doubleIn(step["now_s"]), doubleIn(step["ttl_ms"]), integerIn(step["seq"]))),
        should_hold: (step) => ({ hold: watchdog.shouldHold(doubleIn(step["now_s"])) }),
        reset: () => done(watchdog.reset()),
      });
    },
  ],
  [
    "buffer.run",
    (args) => {
      const buffer = new ActionBuffer(strictIn(args));
      return trace(args, {
        command: (step) => done(buffer.receive(frameIn(step), doubleIn(step["now_s"]))),
        active: (step) => {
          const channels = buffer.active(doubleIn(step["now_s"]));
          return { channels: channels === null ? null : mapOut(channels, channelOut) };
        },
        reset: () => done(buffer.reset()),
      });
    },
  ],
  ["horizon.max_len", (args) => ({ len: maxHorizonLen(doubleIn(args["ttl_ms"]), doubleIn(args["dt_ms"])) })],
  [
    "link.run",
    (args) => {
      const refLoss = doubleOrNullIn(args["ref_loss"]);
      const threshold = doubleOrNullIn(args["threshold"]);
      const monitor = new LinkMonitor(refLoss ?? undefined, threshold ?? undefined);
      return trace(args, {
        frame: (step) => {
          const report = monitor.onFrame(integerIn(step["seq"]));
          return { ...report, loss_rate: doubleOut(report.loss_rate) };
        },
      });
    },
  ],
  [
    "codec.encode",
    (args) => {
      const rates = codecIn(args).encode(messageOrNullIn("sensor_frame", args["sensor"]));
      return { rates: mapOut(rates, doubleOut) };
    },
  ],
  [
    "codec.decode",
    (args) => {
      const { rates = null } = args;
      if (!isObject(rates)) throw new Refusal("type", "the rates are an object");
      const command = codecIn(args).decode(
        new Map(Object.entries(rates).map(([population, rate]) => [population, doubleIn(rate)])),
        {
          t: doubleIn(args["t"]),
          seq: integerIn(args["seq"]),
          frame_id: textIn(args, "frame_id"),
          mode: textIn(args, "mode") as Mode,
        },
      );
      return { command: messageOut(command) };
    },
  ],
  [
    "reflex.step",
    (args) => {
      const controller = new ReflexController(configIn(args));
      return { command: messageOut(controller.step(messageOrNullIn("sensor_frame", args["sensor"]))) };
    },
  ],
  ["loop.run", runLoop],
  [
    "session.run",
    (args) => {
      const service = new SessionService(new ReferenceBackend(), { strict: strictIn(args) });
      const texts = (name: string): string[] => listIn(args, name).map((text) => textIn({ text }, "text"));
      const verbs = (args["verbs"] === undefined ? [] : texts("verbs")) as RequestKind[];
      return { replies: texts("requests").map((request, nth) => service.handle(request, verbs[nth])) };
    },
  ],
];

function runLoop(args: Args): Json {
  let nowS = 0;
  let command: CommandFrame | undefined;
  let status: ControlStatus | undefined;
  const loop = new ControlLoop({
    periodMs: doubleIn(args["period_ms"]),
    controller: new ReflexController(configIn(args)),
    governor: new SafetyGovernor(limitsIn(args)),
    monitor: new LinkMonitor(),
    clock: () => nowS,
    send: (sent) => (command = sent),
    publish: (published) => (status = published),
  });
  return trace(args, {
    sensor: (step) => {
      const sensor = messageIn("sensor_frame", step["sensor"]);
      nowS = doubleIn(step["now_s"]);
      return done(loop.onSensor(sensor));
    },
    tick: (step) => {
      nowS = doubleIn(step["now_s"]);
      command = status = undefined;
      loop.tick();
      return {
        command: command === undefined ? null : messageOut(command),
        status: status === undefined ? null : messageOut(status),
      };
    },
    reset: () => done(loop.reset()),
  });
}

// --- traces --------------------------------------------------------------------------------------

/** Does the steps in their order. One that is refused is answered with why, and the trace goes on. */
function trace(args: Args, ops: Readonly<Record<string, (step: Args) => Json>>): Json {
  const steps = listIn(args, "steps").map((step) => {
    try {
      if (!isObject(step)) throw new Refusal("invalid", "a step is an object");
      const op = textIn(step, "op");
      const does = Object.hasOwn(ops, op) ? ops[op] : undefined;
      if (does === undefined) throw new Refusal("invalid", `there is no step ${op}`);
      return does(step);
    } catch (error) {
      return { error: refusalOut(error) };
    }
  });
  return { steps };
}

/** The answer to a step without a result. */
function done(_: unknown): Json {
  return {};
}

// --- arguments and results -----------------------------------------------------------------------

function limitsIn(args: Args): SafetyLimits {
  return messageIn("capabilities", { controller_id: "", safety: args["limits"] ?? {} }).safety;
}

function configIn({ config }: Args): ReflexConfig {
  if (config === undefined || config === null) return {};
  if (!isObject(config)) throw new Refusal("type", "the configuration is an object");
  const number = (name: string): number | undefined => doubleOrNullIn(config[name]) ?? undefined;
  const target = config["target"] ?? null;
  return {
    target: target === null ? undefined : listIn(config, "target").map(doubleIn),
    kp: number("kp"),
    kd: number("kd"),
    max_speed: number("max_speed"),
  };
}

function codecIn({ codec }: Args): RateCodec {
  if (codec === "uav") return new RateCodec(UAV_CODEC);
  if (!isObject(codec)) throw new Refusal("invalid", "there is no such codec");
  const mappings = (name: string): DecoderMapping[] => listIn({ [name]: [], ...codec }, name).map(mappingIn);
  return new RateCodec({ encoders: mappings("encoders"), decoders: mappings("decoders") });
}

function mappingIn(mapping: Json): DecoderMapping {
  if (!isObject(mapping)) throw new Refusal("type", "a mapping is an object");
  return {
    channel: textIn(mapping, "channel"),
    component: integerIn(mapping["component"]),
    population: textIn(mapping, "population"),
    value_range: rangeIn(mapping, "value_range"),
    rate_range: rangeIn(mapping, "rate_range"),
    unit: textOrNullIn(mapping, "unit"),
  };
}

function rangeIn(mapping: Args, name: string): Range | undefined {
  if (mapping[name] === undefined || mapping[name] === null) return undefined;
  const [begin, end, ...rest] = listIn(mapping, name).map(doubleIn);
  if (begin === undefined || end === undefined || rest.length > 0) throw new Refusal("type", "a range has two ends");
  return [begin, end];
}

function channelOut({ data, unit }: ChannelValue): Json {
  return { data: Array.from(data, doubleOut), unit };
}
