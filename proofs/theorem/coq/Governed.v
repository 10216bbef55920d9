(** The first theorem: from the command that the governor lets pass to the plant that follows it. *)

From Coq Require Import ZArith Reals Psatz Bool Arith.
From Flocq Require Import Core BinarySingleNaN.
From NCP Require Import Kernel Doubles Ball Inside Step Horizon Clock Motion.

Open Scope R_scope.

(** ** What it means that a command has passed the gates *)

Lemma keep_truncated : forall (velocities : nat -> option (vec doubles)) dt ttl radius more at_ kept,
  let n := keep velocities dt ttl radius at_ kept more in
  (n <= kept + more)%nat /\ keep velocities dt ttl radius at_ kept (n - kept) = n.
Proof.
  intros velocities dt ttl radius more. induction more as [|more IH]; intros at_ kept n; unfold n; cbn [keep].
  - rewrite Nat.sub_diag. split; [lia|reflexivity].
  - assert (Base : (kept <= kept + Datatypes.S more)%nat /\ keep velocities dt ttl radius at_ kept (kept - kept) = kept)
      by (rewrite Nat.sub_diag; split; [lia|reflexivity]).
    destruct (velocities (Datatypes.S kept)) as [v|] eqn:V; [|exact Base].
    destruct (after at_ v (tick_share_ms (Datatypes.S kept) dt ttl) radius) as [e|] eqn:A; [|exact Base].
    specialize (IH e (Datatypes.S kept)). cbv zeta in IH. destruct IH as (B & C).
    pose proof (keep_more velocities dt ttl radius more e (Datatypes.S kept)) as M.
    set (m := keep velocities dt ttl radius e (Datatypes.S kept) more) in *. split; [lia|].
    replace (m - kept)%nat with (Datatypes.S (m - Datatypes.S kept)) by lia. cbn [keep]. now rewrite V, A.
Qed.

(** What is kept of a horizon is kept again of the truncated command. *)
Lemma steps_inside_truncated : forall (p : plan doubles) (place : vec doubles) (radius : num doubles) (n : nat),
  steps_inside p place radius = Ok n -> (n <= steps p)%nat /\ steps_inside (truncated p n) place radius = Ok n.
Proof.
  intros p place radius n H. unfold steps_inside in *.
  cbn [velocity ttl_ms dt_ms steps truncated] in *. cbv zeta in *.
  destruct (velocity p 0) as [v|] eqn:V; [|discriminate].
  set (ttl := match enforced_ttl_ms (ttl_ms p) with Some ttl => ttl | None => zero end) in *.
  set (dt := match dt_ms p with Some dt => dt | None => not_a_number end) in *.
  set (alone := match after place v ttl radius with Some _ => Ok 0%nat | None => Err LeavesFence end) in *.
  assert (Alone : alone = Ok n -> n = 0%nat).
  { unfold alone. intros X. destruct (after place v ttl radius); [|discriminate]. congruence. }
  destruct (Nat.eqb_spec (steps p) 0) as [Z|Z].
  - pose proof (Alone H) as N. subst n. split; [lia|exact H].
  - destruct (after place v (tick_share_ms 0 dt ttl) radius) as [e|] eqn:A; [|discriminate].
    destruct (Nat.eqb_spec (keep (velocity p) dt ttl radius e 0 (steps p)) 0) as [K|K].
    + pose proof (Alone H) as N. subst n. split; [lia|exact H].
    + injection H as H. pose proof (keep_truncated (velocity p) dt ttl radius (steps p) e 0) as T. cbv zeta in T.
      rewrite H in *. destruct T as (T1 & T2). rewrite Nat.sub_0_r in T2. split; [lia|].
      destruct (Nat.eqb_spec n 0); [contradiction|]. rewrite T2.
      destruct (Nat.eqb_spec n 0); [contradiction|reflexivity].
Qed.

Lemma limit_steps_ok : forall limited more any step n changed,
  limit_steps limited any step more = (changed, n) ->
  (step <= n <= step + more)%nat /\ forall k, (step < k <= n)%nat -> exists c, limited k = Ok c.
Proof.
  intros limited more. induction more as [|more IH]; intros any step n changed H; cbn [limit_steps] in H.
  - injection H as <- <-. split; [lia|]. intros k K. lia.
  - destruct (limited (Datatypes.S step)) as [c|why] eqn:L.
    + destruct (IH _ _ _ _ H) as (A & B). split; [lia|]. intros k K.
      destruct (Nat.eq_dec k (Datatypes.S step)) as [->|]; [now exists c|]. apply B. lia.
    + injection H as <- <-. split; [lia|]. intros k K. lia.
Qed.

Lemma limit_ticks_ok : forall (p : plan doubles) changed n, limit_ticks p = Ok (changed, n) ->
  (steps p <> 0%nat -> exists dt, dt_ms p = Some dt /\ is_duration dt = true) /\ (n <= steps p)%nat /\
  forall k, (k <= n)%nat -> exists c, limited p k = Ok c.
Proof.
  intros p changed n H. unfold limit_ticks in H. cbv zeta in H.
  destruct (Nat.eqb_spec (steps p) 0) as [Z|Z]; cbn [negb andb] in H.
  - destruct (limited p 0) as [c|why] eqn:L; [|discriminate]. injection H as H.
    destruct (limit_steps_ok _ _ _ _ _ _ H) as (A & B). split; [now intros N|]. split; [lia|].
    intros [|k] K; [now exists c|]. apply B. lia.
  - destruct (match dt_ms p with Some dt => is_duration dt | None => false end) eqn:D; [|discriminate].
    destruct (dt_ms p) as [dt|] eqn:Dt; [|discriminate]. cbn [negb] in H.
    destruct (limited p 0) as [c|why] eqn:L; [|discriminate]. injection H as H.
    destruct (limit_steps_ok _ _ _ _ _ _ H) as (A & B). split; [intros _; now exists dt|]. split; [lia|].
    intros [|k] K; [now exists c|]. apply B. lia.
Qed.

(** A command passes the gates of a governor with a fence only when all of this is so. *)
Theorem passed : forall (g g' : gates doubles) (p : plan doubles) now last position (radius : num doubles) d n,
  fence_m g = Enabled radius -> govern g p now last position = (d, g', n) -> d = Passed \/ d = Limited ->
  exists measured, position = Some measured /\ inside measured radius = true /\ plan_mode p = Active /\
    latched g = false /\ config_fault g = false /\ (n <= steps p)%nat /\
    steps_inside (truncated p n) measured radius = Ok n /\
    (steps p <> 0%nat -> exists dt, dt_ms p = Some dt /\ is_duration dt = true) /\
    (forall k, (k <= n)%nat -> exists c, limited p k = Ok c).
Proof.
  intros g g' p now last position radius d n Hf H Hd. unfold govern in H.
  set (g1 := match plan_mode p with Estop => latch g | _ => g end) in *.
  destruct (latched g1) eqn:L; [injection H as <- _ _; destruct Hd; discriminate|].
  destruct (config_fault g1) eqn:C; [injection H as <- _ _; destruct Hd; discriminate|].
  destruct (negb _) in H; [injection H as <- _ _; destruct Hd; discriminate|]. cbv zeta in H.
  assert (F1 : fence_m g1 = Enabled radius) by (unfold g1; destruct (plan_mode p); assumption). rewrite F1 in H.
  destruct position as [measured|]; [|injection H as <- _ _; destruct Hd; discriminate].
  destruct (inside measured radius) eqn:I; [|injection H as <- _ _; destruct Hd; discriminate].
  destruct (plan_mode p) eqn:M; try (injection H as <- _ _; destruct Hd; discriminate).
  destruct (limit_ticks p) as [(changed, usable)|why] eqn:T; [|injection H as <- _ _; destruct Hd; discriminate].
  destruct (steps_inside (truncated p usable) measured radius) as [kept|why] eqn:S;
    [|injection H as <- _ _; destruct Hd; discriminate].
  injection H as _ _ <-. destruct (limit_ticks_ok p changed usable T) as (T1 & T2 & T3).
  destruct (steps_inside_truncated _ _ _ _ S) as (S1 & S2). simpl steps in S1.
  exists measured. repeat split; try assumption; try lia.
  intros k K. apply T3. lia.
Qed.

(** ** The speed limit, in exact arithmetic *)

Lemma positive_sign : forall x : double, 0 < B2R x -> Bsign x = false.
Proof.
  intros x H. destruct x as [| | |[] m e b]; try (exfalso; simpl in H; lra); [|reflexivity].
  exfalso. assert (N : F2R (Float radix2 (Z.neg m) e) < 0) by (apply F2R_lt_0; reflexivity).
  simpl in H, N. lra.
Qed.

(** A product of what is above 0 is not below it, and infinite where it overflows. *)
Lemma mul_positive : forall x y : num doubles, finite x = true -> finite y = true -> 0 < val x -> 0 < val y ->
  le zero (mul x y) = true.
Proof.
  intros x y Fx Fy Px Py. destruct zero_val as (Fz & Z).
  destruct (finite (mul x y)) eqn:Fm.
  - apply val_le; try assumption. apply mul_finite in Fm as (_ & _ & ->). rewrite Z.
    apply rnd_nonneg. apply Rlt_le. now apply Rmult_lt_0_compat.
  - pose proof (Bmult_correct 53 1024 precise bounded mode_NE x y) as C.
    change (is_finite (Bmult mode_NE (x : double) (y : double)) = false) in Fm.
    change (Bleb (zero : num doubles) (Bmult mode_NE (x : double) (y : double)) = true).
    destruct Rlt_bool.
    + exfalso. destruct C as (_ & D & _). unfold double in *. rewrite D in Fm.
      change (is_finite (x : double) = true) in Fx. change (is_finite (y : double) = true) in Fy.
      unfold double in *. rewrite Fx, Fy in Fm. discriminate.
    + rewrite (positive_sign x Px), (positive_sign y Py) in C.
      destruct (Bmult mode_NE (x : double) (y : double)) as [|[]| |]; try discriminate. reflexivity.
Qed.

Lemma zeros_scale : scale (zero, zero, zero) = (up : num doubles).
Proof.
  assert (L : lt (squares (zero, zero, zero)) (small : num doubles) = true) by (vm_compute; reflexivity).
  unfold scale, select_lt. now rewrite L.
Qed.

Lemma zeros_norm : norm (zero, zero, zero) = (zero : num doubles).
Proof.
  unfold norm. rewrite zeros_scale. destruct (power_exact 600 ltac:(lia)) as (Fu & Vu).
  fold (up : num doubles) in Fu, Vu.
  assert (M : mul zero up = (zero : num doubles)).
  { assert (P : 0 < val up) by (rewrite Vu; apply bpow_gt_0). apply positive_sign in P.
    clear Vu. revert Fu P. generalize (up : num doubles). intros x F P.
    destruct x as [[]| | |[]]; try discriminate; reflexivity. }
  unfold scaled. rewrite !M. vm_compute. reflexivity.
Qed.

Lemma zeros_within : forall max : num doubles, finite max = true -> lt zero max = true ->
  norm_le (zero, zero, zero) max = true.
Proof.
  intros max F P. unfold norm_le. rewrite zeros_scale, zeros_norm.
  destruct zero_val as (Fz & Z). pose proof (lt_val zero max Fz F P) as V. rewrite Z in V.
  destruct (power_exact 600 ltac:(lia)) as (Fu & Vu). apply mul_positive; try assumption.
  unfold up. rewrite Vu. apply bpow_gt_0.
Qed.

(** What the clamp lets be used is not above the bound by the norm that is computed. *)
Theorem bring_within_norm : forall (v w : vec doubles) (max : num doubles) changed,
  bring_within v max = Some (w, changed) -> finite max = true /\ lt zero max = true /\ norm_le w max = true.
Proof.
  intros v w max changed H. unfold bring_within in H.
  destruct (all_finite v); [|discriminate]. destruct (finite max) eqn:F; [|discriminate].
  destruct (lt zero max) eqn:P; [|discriminate]. cbn [negb orb] in H. split; [reflexivity|]. split; [reflexivity|].
  destruct (norm_le v max) eqn:L; [injection H as <- _; exact L|]. cbv zeta in H.
  match type of H with Some (if negb (norm_le ?x max) then _ else _, _) = _ => set (scaled_ := x) in * end.
  destruct (norm_le scaled_ max) eqn:N; cbn [negb] in H; injection H as <- _; [exact N|].
  now apply zeros_within.
Qed.

(** The greatest component of a velocity that the limit lets pass. *)
Definition limited_speed (max : R) : R := max * (1 + 3 * u) + delta.

Lemma limited_slow : forall (v : vec doubles) (max : num doubles), finite max = true -> lt zero max = true ->
  norm_le v max = true -> slow (place v) (limited_speed (val max)).
Proof.
  intros v max F P L. pose proof (norm_le_exact v max F P L) as N. destruct v as ((x, y), z).
  apply component_le_far in N. unfold slow, place, near. rewrite !Rminus_0_r. exact N.
Qed.

(** ** The theorem *)

(** A plant that is where it was measured and follows one governed command exactly stays, from the receipt of the command
    on and until its watchdog has held it, within the ball of the radius, but for [excursion]. *)
Theorem governed_plant_stays_within :
  forall {Q : Sequence} (g g' : gates doubles) (p : plan doubles) (now : num doubles) (last : option (num doubles))
    (measured : vec doubles) (radius : num doubles) (d : decision) (n : nat)
    (received : num doubles) (q : seq Q) (speed kappa : R) (clock : R -> num doubles) (position : R -> point) (held : R),
  (* The governor has a fence, knows a position, and lets the command pass with [n] steps. *)
  fence_m g = Enabled radius -> govern g p now last (Some measured) = (d, g', n) -> d = Passed \/ d = Limited ->
  (Z.of_nat (steps p) < 2 ^ 53)%Z ->
  (* No component of a velocity that is sent is above [speed]. *)
  0 <= speed -> (forall k, (k <= n)%nat -> slow (velocity_of p k) speed) ->
  (* The plant follows what is sent. *)
  following (truncated p n) measured received q speed kappa clock position held ->
  forall age, 0 <= age ->
  far (position age) <= val radius + excursion (val radius) speed (INR (n + 1)) (val (enforced p)) kappa.
Proof.
  intros Q g g' p now last measured radius d n received q speed kappa clock position held
    Hf Hg Hd H53 Hsp Hsl HF age Ha.
  destruct (passed g g' p now last (Some measured) radius d n Hf Hg Hd)
    as (m & Em & Hin & _ & _ & _ & Hn & Hs & Hdt & _).
  injection Em as <-.
  pose proof (within (truncated p n) measured received radius q speed kappa clock position held HF Hsp Hin Hsl Hs) as W.
  cbn [steps truncated] in W. rewrite Nat.add_1_r. apply W; [lia| |exact Ha].
  intros Z. apply Hdt. lia.
Qed.

(** The same with the speed limit on: [limits_act] says that [Plan::limit] brings the velocity of a tick within it. *)
Theorem limited_plant_stays_within :
  forall {Q : Sequence} (g g' : gates doubles) (p : plan doubles) (now : num doubles) (last : option (num doubles))
    (measured : vec doubles) (radius max : num doubles) (d : decision) (n : nat)
    (received : num doubles) (q : seq Q) (kappa : R) (clock : R -> num doubles) (position : R -> point) (held : R),
  fence_m g = Enabled radius -> govern g p now last (Some measured) = (d, g', n) -> d = Passed \/ d = Limited ->
  (Z.of_nat (steps p) < 2 ^ 53)%Z ->
  0 <= val max ->
  forall limits_act : forall k c, limited p k = Ok c -> exists v w b,
    bring_within v max = Some (w, b) /\ velocity p k = Some w,
  following (truncated p n) measured received q (limited_speed (val max)) kappa clock position held ->
  forall age, 0 <= age ->
  far (position age) <= val radius +
    excursion (val radius) (limited_speed (val max)) (INR (n + 1)) (val (enforced p)) kappa.
Proof.
  intros Q g g' p now last measured radius max d n received q kappa clock position held Hf Hg Hd H53 Hm Hl HF age Ha.
  assert (Hsp : 0 <= limited_speed (val max)).
  { unfold limited_speed. pose proof u_pos. pose proof delta_pos.
    assert (0 <= val max * (1 + 3 * u)) by (apply Rmult_le_pos; lra). lra. }
  eapply governed_plant_stays_within; try eassumption.
  intros k K. destruct (passed g g' p now last (Some measured) radius d n Hf Hg Hd)
    as (m & _ & _ & _ & _ & _ & _ & _ & _ & L).
  destruct (L k K) as (c & C). destruct (Hl k c C) as (v & w & b & B & V).
  destruct (bring_within_norm v w max b B) as (Fm & Pm & N).
  unfold velocity_of. rewrite V. now apply limited_slow.
Qed.

(** [excursion] in one line: for [n] + 1 ticks at no more than the speed of light. *)
Theorem excursion_simply : forall r v (n : nat) t kappa,
  0 <= r -> 0 <= v <= bpow radix2 30 -> (Z.of_nat n < 2 ^ 53)%Z -> 0 <= t <= 60000 -> 0 <= kappa ->
  excursion r v (INR (n + 1)) t kappa <=
    INR (n + 2) * (bpow radix2 (-51) * r + bpow radix2 (-46) * (v * (t / 1000)) + 8 * (v * (kappa / 1000)))
    + bpow radix2 (-400).
Proof.
  intros r v n t kappa Hr (Hv & Hv') Hn Ht Hk. rewrite !plus_INR. simpl (INR 1). simpl (INR 2).
  assert (N0 : 0 <= INR n) by apply pos_INR.
  assert (N1 : INR n <= bpow radix2 53).
  { change (bpow radix2 53) with (IZR (2 ^ 53)). rewrite INR_IZR_INZ. apply IZR_le. lia. }
  unfold excursion, step_error, slack.
  change (bpow radix2 (-51)) with (bpow radix2 (2 + -53)). change (bpow radix2 (-46)) with (bpow radix2 (7 + -53)).
  rewrite !bpow_plus. fold u. replace (bpow radix2 2) with 4 by reflexivity. replace (bpow radix2 7) with 128 by reflexivity.
  set (N := INR n) in *. pose proof u_pos as U. pose proof delta_pos as D.
  set (w := v * (t / 1000)) in *. assert (W : 0 <= w) by (unfold w; apply Rmult_le_pos; lra).
  set (c := v * (kappa / 1000)) in *. assert (C : 0 <= c) by (unfold c; apply Rmult_le_pos; lra).
  assert (S : delta * (1 + 4 * (N + 1) * (1 + v) + v) <= bpow radix2 (-400)).
  { unfold delta. replace (bpow radix2 (-400)) with (bpow radix2 (-536) * bpow radix2 136) by (rewrite <- bpow_plus; reflexivity).
    apply Rmult_le_compat_l; [apply bpow_ge_0|].
    assert (B30 : bpow radix2 30 = 1073741824) by reflexivity.
    assert (B53 : bpow radix2 53 = 9007199254740992) by reflexivity.
    assert (B136 : bpow radix2 136 = 87112285931760246646623899502532662132736) by reflexivity.
    rewrite B30 in Hv'. rewrite B53 in N1. rewrite B136.
    assert ((N + 1) * (1 + v) <= (9007199254740992 + 1) * (1 + 1073741824)) by (apply Rmult_le_compat; lra). lra. }
  assert (E : v * (kappa + 8 * u * t + delta) / 1000 = c + 8 * (u * w) + v * delta / 1000) by (unfold c, w; field).
  rewrite E. replace (v * t / 1000) with w by (unfold w; field).
  assert (X1 : 0 <= u * r) by (apply Rmult_le_pos; lra). assert (X2 : 0 <= u * w) by (apply Rmult_le_pos; lra).
  assert (X3 : 0 <= N * (u * r)) by (now apply Rmult_le_pos). assert (X4 : 0 <= N * (u * w)) by (now apply Rmult_le_pos).
  assert (X5 : 0 <= N * c) by (now apply Rmult_le_pos). assert (X6 : 0 <= v * delta) by (apply Rmult_le_pos; lra).
  assert (X7 : 0 <= N * (v * delta)) by (now apply Rmult_le_pos). assert (X8 : 0 <= N * delta) by (apply Rmult_le_pos; lra).
  nra.
Qed.
