(** How Coq sees that what the source does, path by path, is what the model says. *)

From Coq Require Import ZArith List Bool Lia.
From NCP Require Import Kernel.

(** What the export asks of an index. *)
Definition index_is {S : Scalar} (index most : nat) (x : num S) : bool := Nat.eqb (floor_index x most) index.

(** All of the model's names away, but for [squares] and [scale]: what is left is numbers, their operations and their
    comparisons. *)
Ltac open_model :=
  cbv beta iota zeta delta [
    is_duration enforced_ttl_ms age_ms within_deadline is_fresh limit_of small norm norm_le all_finite
    scaled rescaled margin bring_within limit_velocity inside travel tick_share_ms after keep steps_inside open_gates latch is_faulty is_disabled note_link
    reset_gates bind limit_steps limit_ticks govern advances hold_takes_effect on_command stop should_hold active
    new_plant truncated whole zero thousand max_ttl_ms
    plan_mode ttl_ms dt_ms steps limited velocity max_speed_mps fence_m timeout_ms config_fault latched
    last_seq deadline stopped
    negb andb orb Nat.eqb Nat.ltb Nat.leb Nat.add
    Z.of_nat Pos.of_succ_nat Pos.succ ].

(** What the path has decided, where the model asks it again. *)
Ltac use_path :=
  repeat match goal with H : ?c = ?answer |- context [?c] => rewrite H; cbv beta iota end.

(** The source's next condition, both ways. An index is one of those that it may be. *)
Ltac next_condition bounded :=
  lazymatch goal with
  | |- _ = (if index_is _ ?most ?x then _ else _) =>
      use_path; generalize (bounded x most); unfold index_is;
      destruct (floor_index x most) as [|[|[|[|[|?]]]]]; intro;
      try (exfalso; lia); cbv beta iota delta [Nat.eqb]
  | |- _ = (if ?c then _ else _) => destruct c eqn:?; cbv beta iota
  end.

Ltac tie bounded :=
  intros; open_model; cbv delta [zero] in *; use_path; repeat next_condition bounded;
  first [reflexivity | use_path; reflexivity].
