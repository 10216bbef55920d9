(** The safety kernel's algorithm, line for line as [spec/kernel/src/decisions] has it, over any numbers and any seqs.

    [Exported.v], which is made from the Rust source, holds what the source does on terms; there Coq proves that it is
    what is written here. *)

From Coq Require Import ZArith List Bool.

(** What the kernel needs of a number: [ncp_kernel::Scalar]. *)
Record Scalar := {
  num : Type;
  (** The number nearest to m * 2^e. *)
  dyadic : Z -> Z -> num;
  not_a_number : num;
  add : num -> num -> num;
  sub : num -> num -> num;
  mul : num -> num -> num;
  div : num -> num -> num;
  root : num -> num;
  abs : num -> num;
  lt : num -> num -> bool;
  le : num -> num -> bool;
  finite : num -> bool;
  floor_index : num -> nat -> nat }.

(** What it needs of a seq: [ncp_kernel::Seq]. *)
Record Sequence := {
  seq : Type;
  seq_lt : seq -> seq -> bool;
  seq_zero : seq -> bool }.

Arguments dyadic {_}. Arguments not_a_number {_}. Arguments add {_}. Arguments sub {_}. Arguments mul {_}.
Arguments div {_}. Arguments root {_}. Arguments abs {_}. Arguments lt {_}. Arguments le {_}. Arguments finite {_}.
Arguments floor_index {_}. Arguments seq_lt {_}. Arguments seq_zero {_}.

Inductive mode := Init | Active | Hold | Estop.

Inductive reason :=
  | EstopReason | ConfigFault | StaleSensor | NoPosition | OutsideFence | NotActive | NotFinite | NoVelocity
  | BadHorizon | LeavesFence.

Inductive result (A : Type) := Ok (value : A) | Err (why : reason).
Arguments Ok {A}. Arguments Err {A}.

Inductive decision := Passed | Limited | Held (why : reason) | Stopped (why : reason).

Inductive received := WasAccepted | WasHeld | WasStopped | WasDropped.

Section Numbers.
Context {S : Scalar}.
Notation num := (num S).

Inductive limit := Disabled | Enabled (bound : num) | Faulty.

Definition vec : Type := num * num * num.

Definition whole (n : nat) : num := dyadic (Z.of_nat n) 0.
Definition zero : num := dyadic 0 0.
Definition thousand : num := dyadic 1000 0.
Definition max_ttl_ms : num := dyadic 60000 0.

(** ** deadline.rs *)

Definition is_duration (value : num) : bool := finite value && lt zero value.

Definition enforced_ttl_ms (ttl_ms : num) : option num :=
  if negb (is_duration ttl_ms) then None else Some (if lt ttl_ms max_ttl_ms then ttl_ms else max_ttl_ms).

Definition age_ms (now_s then_s : num) : num := mul (sub now_s then_s) thousand.

Definition within_deadline (now_s received_s ttl_ms : num) : bool :=
  match enforced_ttl_ms ttl_ms with
  | None => false
  | Some ttl_ms =>
      if negb (finite now_s) || negb (finite received_s) || negb (le received_s now_s) then false
      else le (age_ms now_s received_s) ttl_ms
  end.

Definition is_fresh (now_s last_s timeout_ms : num) : bool :=
  if negb (is_duration timeout_ms) then false
  else if negb (finite now_s) || negb (finite last_s) || negb (le last_s now_s) then false
  else le (age_ms now_s last_s) timeout_ms.

(** ** speed.rs, for three components *)

Definition limit_of (value : option num) : limit :=
  match value with
  | None => Disabled
  | Some value =>
      if negb (finite value) || lt value zero then Faulty
      else if lt zero value then Enabled value else Disabled
  end.

(** [ncp_kernel::Scalar::select_lt]. *)
Definition select_lt (a b than_ otherwise : num) : num := if lt a b then than_ else otherwise.

Definition small : num := dyadic 1 (-900).
Definition large : num := dyadic 1 1000.
Definition up : num := dyadic 1 600.
Definition down : num := dyadic 1 (-600).

Definition scaled (v : vec) (by_ : num) : vec := let '(x, y, z) := v in (mul x by_, mul y by_, mul z by_).

Definition squares (v : vec) : num :=
  let '(x, y, z) := v in add (add (add zero (mul x x)) (mul y y)) (mul z z).

(** By how much a vector is multiplied before it is squared. *)
Definition scale (v : vec) : num :=
  select_lt (squares v) small up (select_lt (squares v) large (whole 1) down).

(** The norm at this scale. *)
Definition norm (v : vec) : num := root (squares (scaled v (scale v))).

Definition norm_le (v : vec) (bound : num) : bool := le (norm v) (mul bound (scale v)).

Definition all_finite (v : vec) : bool := let '(x, y, z) := v in finite x && finite y && finite z.

(** 1 - (3 + 8) * 2^-53. *)
Definition margin : num := dyadic 9007199254740981 (-53).

(** A vector brought to the norm 1 first, and then to the bound. *)
Definition rescaled (v : vec) (by_ length aim : num) : vec :=
  let '(x, y, z) := v in
  (mul (div (mul x by_) length) aim, mul (div (mul y by_) length) aim, mul (div (mul z by_) length) aim).

(** The vector that is to be used, and whether it was above the bound; none for what is not to be used. *)
Definition bring_within (v : vec) (max : num) : option (vec * bool) :=
  if negb (all_finite v) || negb (finite max) || negb (lt zero max) then None
  else if norm_le v max then Some (v, false)
  else
    let aim := mul max margin in
    let factor := div (mul aim (scale v)) (norm v) in
    let v := if le small factor then scaled v factor else rescaled v (scale v) (norm v) aim in
    Some (if negb (norm_le v max) then (zero, zero, zero) else v, true).

(** A tick whose one channel is the velocity, in m/s, by [limit_tick]: the velocity to use, and whether it changed. *)
Definition limit_velocity (v : vec) (max : num) : result (vec * bool) :=
  if negb (all_finite v) then Err NotFinite
  else match bring_within v max with Some limited => Ok limited | None => Err NoVelocity end.

(** ** fence.rs *)

Definition inside (position : vec) (radius : num) : bool :=
  all_finite position && finite radius && lt zero radius && norm_le position radius.

Definition travel (position velocity : vec) (time_s : num) : vec :=
  let '(x, y, z) := position in
  let '(u, v, w) := velocity in
  (add x (mul u time_s), add y (mul v time_s), add z (mul w time_s)).

Definition tick_share_ms (tick : nat) (dt_ms ttl_ms : num) : num :=
  let start := mul (whole tick) dt_ms in
  if negb (lt start ttl_ms) then zero
  else
    let rest := sub ttl_ms start in
    if lt dt_ms rest then dt_ms else rest.

(** A command as the governor sees it. [limited] is what [Plan::limit] answers for a tick, [velocity] the tick's velocity
    once the speed limit has been applied. *)
Record plan := {
  plan_mode : mode;
  ttl_ms : num;
  dt_ms : option num;
  steps : nat;
  limited : nat -> result bool;
  velocity : nat -> option vec }.

Definition truncated (p : plan) (steps : nat) : plan :=
  {| plan_mode := plan_mode p; ttl_ms := ttl_ms p; dt_ms := dt_ms p; steps := steps;
     limited := limited p; velocity := velocity p |}.

Definition after (from velocity : vec) (time_ms radius : num) : option vec :=
  let place := travel from velocity (div time_ms thousand) in
  if inside place radius then Some place else None.

(** How many steps are kept when [kept] of them end inside, the last of these at [place], and [more] are to be tried. *)
Fixpoint keep (velocity : nat -> option vec) (dt_ms ttl_ms radius : num) (place : vec) (kept more : nat) : nat :=
  match more with
  | O => kept
  | Datatypes.S more =>
      let tick := Datatypes.S kept in
      match velocity tick with
      | None => kept
      | Some v =>
          match after place v (tick_share_ms tick dt_ms ttl_ms) radius with
          | None => kept
          | Some place => keep velocity dt_ms ttl_ms radius place tick more
          end
      end
  end.

Definition steps_inside (p : plan) (position : vec) (radius : num) : result nat :=
  match velocity p 0 with
  | None => Err NoVelocity
  | Some v =>
      let ttl := match enforced_ttl_ms (ttl_ms p) with Some ttl => ttl | None => zero end in
      let alone := match after position v ttl radius with Some _ => Ok 0 | None => Err LeavesFence end in
      if Nat.eqb (steps p) 0 then alone
      else
        let dt := match dt_ms p with Some dt => dt | None => not_a_number end in
        match after position v (tick_share_ms 0 dt ttl) radius with
        | None => Err LeavesFence
        | Some place =>
            let kept := keep (velocity p) dt ttl radius place 0 (steps p) in
            if Nat.eqb kept 0 then alone else Ok kept
        end
  end.

(** ** gates.rs *)

Record gates := { max_speed_mps : limit; fence_m : limit; timeout_ms : num; config_fault : bool; latched : bool }.

Definition is_faulty (l : limit) : bool := match l with Faulty => true | _ => false end.

Definition is_disabled (l : limit) : bool := match l with Disabled => true | _ => false end.

Definition open_gates (max_speed radius : option num) (timeout : num) : gates :=
  {| max_speed_mps := limit_of max_speed; fence_m := limit_of radius; timeout_ms := timeout;
     config_fault := is_faulty (limit_of max_speed) || is_faulty (limit_of radius); latched := false |}.

Definition latch (g : gates) : gates :=
  {| max_speed_mps := max_speed_mps g; fence_m := fence_m g; timeout_ms := timeout_ms g;
     config_fault := config_fault g; latched := true |}.

Definition note_link (g : gates) (burst : bool) : gates := if burst then latch g else g.

Definition reset_gates (g : gates) : gates :=
  {| max_speed_mps := max_speed_mps g; fence_m := fence_m g; timeout_ms := timeout_ms g;
     config_fault := config_fault g; latched := false |}.

Definition bind (g : gates) (has_velocity has_position : bool) : gates :=
  {| max_speed_mps := max_speed_mps g; fence_m := fence_m g; timeout_ms := timeout_ms g;
     config_fault := config_fault g ||
       negb (has_velocity || is_disabled (max_speed_mps g)) || negb (has_position || is_disabled (fence_m g));
     latched := latched g |}.

Fixpoint limit_steps (limited : nat -> result bool) (any : bool) (step more : nat) : bool * nat :=
  match more with
  | O => (any, step)
  | Datatypes.S more =>
      match limited (Datatypes.S step) with
      | Ok changed => limit_steps limited (any || changed) (Datatypes.S step) more
      | Err _ => (any, step)
      end
  end.

(** Whether a velocity changed, and how many steps are left. *)
Definition limit_ticks (p : plan) : result (bool * nat) :=
  let timed := match dt_ms p with Some dt => is_duration dt | None => false end in
  if negb (Nat.eqb (steps p) 0) && negb timed then Err BadHorizon
  else
    match limited p 0 with
    | Err why => Err why
    | Ok changed => Ok (limit_steps (limited p) changed 0 (steps p))
    end.

(** The decision, the gates after it, and how many steps the command still has. *)
Definition govern (g : gates) (p : plan) (now_s : num) (last_s : option num) (position : option vec)
  : decision * gates * nat :=
  let g := match plan_mode p with Estop => latch g | _ => g end in
  if latched g then (Stopped EstopReason, g, steps p)
  else if config_fault g then (Held ConfigFault, g, steps p)
  else if negb (match last_s with Some last_s => is_fresh now_s last_s (timeout_ms g) | None => false end)
  then (Held StaleSensor, g, steps p)
  else
    let move :=
      match plan_mode p with
      | Active =>
          match limit_ticks p with
          | Err why => (Held why, g, steps p)
          | Ok (changed, usable) =>
              let p' := truncated p usable in
              let ends :=
                match fence_m g, position with
                | Enabled radius, Some place => steps_inside p' place radius
                | _, _ => Ok usable
                end in
              match ends with
              | Err why => (Held why, g, usable)
              | Ok kept => (if changed || Nat.ltb kept (steps p) then Limited else Passed, g, kept)
              end
          end
      | _ => (Held NotActive, g, steps p)
      end in
    match fence_m g with
    | Enabled radius =>
        match position with
        | None => (Held NoPosition, g, steps p)
        | Some place => if inside place radius then move else (Stopped OutsideFence, latch g, steps p)
        end
    | _ => move
    end.

(** ** order.rs, watchdog.rs, plant.rs *)

Context {Q : Sequence}.
Notation seq := (seq Q).

Definition advances (last : option seq) (q : seq) : bool :=
  match last with None => true | Some last => seq_lt last q end.

Definition hold_takes_effect (last : option seq) (q : seq) : bool :=
  match last with None => true | Some last => seq_zero q || negb (seq_lt q last) end.

(** A plant with its watchdog: the last seq, the receipt in s and the ttl in ms of the command that it may follow, and
    whether ESTOP is latched. *)
Record plant := Plant { last_seq : option seq; deadline : option (num * num); stopped : bool }.

Definition new_plant : plant := Plant None None false.

Definition on_command (p : plant) (m : mode) (now_s ttl_ms : num) (q : seq) : plant * received :=
  match m with
  | Estop => (Plant (last_seq p) (deadline p) true, WasStopped)
  | Active =>
      if advances (last_seq p) q
      then (Plant (Some q) (Some (now_s, ttl_ms)) (stopped p), if stopped p then WasStopped else WasAccepted)
      else (p, WasDropped)
  | Init | Hold =>
      if hold_takes_effect (last_seq p) q
      then
        (Plant (if advances (last_seq p) q && negb (seq_zero q) then Some q else last_seq p) None (stopped p), WasHeld)
      else (p, WasDropped)
  end.

Definition stop (p : plant) : plant := Plant (last_seq p) (deadline p) true.

Definition should_hold (p : plant) (now_s : num) : plant * bool :=
  match deadline p with
  | Some (received_s, ttl_ms) =>
      if within_deadline now_s received_s ttl_ms then (p, false) else (Plant (last_seq p) None (stopped p), true)
  | None => (p, true)
  end.

(** The tick that the plant actuates. *)
Definition active (p : plant) (now_s : num) (dt_ms : option num) (steps : nat) : plant * option nat :=
  let '(p, held) := should_hold p now_s in
  if held || stopped p then (p, None)
  else
    match deadline p with
    | None => (p, None)
    | Some (received_s, _) =>
        match dt_ms with
        | Some dt =>
            if negb (Nat.eqb steps 0) && is_duration dt then
              let tick := floor_index (div (age_ms now_s received_s) dt) (steps + 1) in
              if Nat.ltb steps tick then (Plant (last_seq p) None (stopped p), None) else (p, Some tick)
            else (p, Some 0)
        | None => (p, Some 0)
        end
    end.

End Numbers.

Arguments limit : clear implicits.
Arguments vec : clear implicits.
Arguments plan : clear implicits.
Arguments gates : clear implicits.
Arguments plant : clear implicits.
