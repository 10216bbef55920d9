/**
 * How a message is declared: its fields in their order, and of each the type, the default and whether
 * it must be there. Decoder and encoder read these declarations, and the types of the messages are
 * derived from them, so that a field is written down once.
 *
 * @module
 */

/** The type of a field as it travels. */
export type Shape =
  | { readonly is: "string" | "integer" | "number" | "boolean" | "integers" | "numbers" }
  /** A string that is a valid id segment. */
  | { readonly is: "segment" }
  /** A string with one allowed value: the message's kind. */
  | { readonly is: "kind"; readonly value: string }
  /** A boolean with one allowed value: an epistemic pin. */
  | { readonly is: "pin"; readonly value: boolean }
  | { readonly is: "enum"; readonly values: ReadonlySet<string>; readonly unknown: "keep" | "hold" | "reject" }
  | { readonly is: "list"; readonly of: Shape }
  | { readonly is: "map"; readonly of: Shape }
  | { readonly is: "message"; readonly table: Table };

/**
 * One field. `Out` is what a complete message holds, `In` what a program may give when it builds one,
 * and `Named` says whether the program has to.
 */
export interface Field<out Out = unknown, out In = unknown, Named extends boolean = boolean> {
  readonly shape: Shape;
  /** Whether it can be unset, which is `null`. */
  readonly optional: boolean;
  /** Whether a frame must have it. */
  readonly required: boolean;
  /** Whether the encoder leaves it out when it is unset, instead of writing `null`. */
  readonly leftOut: boolean;
  /** What an absent field of a frame reads as. */
  readonly absent: () => unknown;
  /** What a program gets that builds a message without naming the field. */
  readonly built: () => unknown;
  /** For the compiler only: the types, never a value. */
  readonly types?: { readonly out: Out; readonly in: In; readonly named: Named };
}

/** A message: its fields by name, in the order in which they are written. */
export interface Table<F extends Fields = Fields> {
  readonly name: string;
  readonly fields: readonly NamedField[];
  readonly byName: ReadonlyMap<string, NamedField>;
  /** For the compiler only: the declaration, never a value. */
  readonly types?: F;
}

export type Fields = Readonly<Record<string, Field>>;

/** A field in its table. */
export interface NamedField extends Field {
  readonly name: string;
  /** Its own bit, to note which fields were there. */
  readonly bit: number;
}

/** The complete message of a table. */
export type MessageOf<T> =
  T extends Table<infer F>
    ? { -readonly [K in keyof F]: F[K] extends Field<infer Out, unknown, boolean> ? Out : never }
    : never;

/** What a program gives to build the message of a table. */
export type InputOf<T> =
  T extends Table<infer F>
    ? { readonly [K in keyof F as F[K] extends Field<unknown, unknown, true> ? K : never]: Given<F[K]> } & {
        readonly [K in keyof F as F[K] extends Field<unknown, unknown, true> ? never : K]?: Given<F[K]> | undefined;
      }
    : never;

type Given<F> = F extends Field<unknown, infer In, boolean> ? In : never;

/** A map as it may be given: entries by name. */
export type Entries<T> = ReadonlyMap<string, T> | Readonly<Record<string, T>>;

/** Declares a message. */
export function table<const F extends Fields>(name: string, fields: F): Table<F> {
  const named = Object.entries(fields).map(([field, rest], n): NamedField => ({ ...rest, name: field, bit: 1 << n }));
  return { name, fields: named, byName: new Map(named.map((field) => [field.name, field])) };
}

/** A field with a default of a primitive type. */
export function field<Out, In = Out>(shape: Shape, absent: Out): Field<Out, In, false> {
  return { shape, optional: false, required: false, leftOut: false, absent: () => absent, built: () => absent };
}

/** A field whose default is made anew for each message. */
export function fresh<Out, In = Out>(shape: Shape, absent: () => Out): Field<Out, In, false> {
  return { shape, optional: false, required: false, leftOut: false, absent, built: absent };
}

/** A field that a frame must have, and that a program must name. */
export function required<Out, In = Out>(shape: Shape): Field<Out, In, true> {
  return { shape, optional: false, required: true, leftOut: false, absent: unset, built: unset };
}

/** A field that can be unset. */
export function optional<Out, In = Out>(shape: Shape): Field<Out | null, In | null, false> {
  return { shape, optional: true, required: false, leftOut: false, absent: () => null, built: () => null };
}

/** The field, with another default for a program that builds the message. */
export function builtAs<Out, In>(of: Field<Out, In, false>, value: Out): Field<Out, In, false> {
  return { ...of, built: () => value };
}

/** The field, left out by the encoder when it is unset. */
export function leftOut<Out, In>(of: Field<Out, In, false>): Field<Out, In, false> {
  return { ...of, leftOut: true };
}

/** A field that, when it is absent, is settled by the message around it. */
export function inherited<Out, In = Out>(shape: Shape): Field<Out, In, false> {
  return { shape, optional: false, required: false, leftOut: false, absent: unset, built: unset };
}

function unset(): undefined {
  return undefined;
}
