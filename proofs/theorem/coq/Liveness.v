(** The second theorem: latch, hold and watchdog of a plant, for every sequence of inputs, over any numbers and seqs. *)

From Coq Require Import ZArith Reals Psatz List Bool.
From Flocq Require Import Core BinarySingleNaN.
From NCP Require Import Kernel.
Import ListNotations.

Section Traces.
Context {S : Scalar} {Q : Sequence}.
Notation num := (num S).
Notation seq := (seq Q).

(** What happens to a plant. *)
Inductive input :=
  | Command (m : mode) (now_s ttl_ms : num) (q : seq)
  | Ask (now_s : num) (dt_ms : option num) (steps : nat)
  | Stop
  | Reset.

Definition step (p : plant S Q) (i : input) : plant S Q :=
  match i with
  | Command m now ttl q => fst (on_command p m now ttl q)
  | Ask now dt n => fst (active p now dt n)
  | Stop => stop p
  | Reset => new_plant
  end.

Definition run (p : plant S Q) (trace : list input) : plant S Q := fold_left step trace p.

(** The plant moves: an ask would be answered with a tick. *)
Definition moves (p : plant S Q) (now : num) (dt : option num) (n : nat) : Prop := snd (active p now dt n) <> None.

(** The input accepts a command that advances. *)
Definition accepts (p : plant S Q) (i : input) : Prop :=
  match i with Command Active _ _ q => advances (last_seq p) q = true | _ => False end.

(** [following p r ttl]: the plant may follow the command received at [r] with [ttl]. *)
Definition may_follow (p : plant S Q) (r ttl : num) : Prop := deadline p = Some (r, ttl).

Lemma run_app : forall p a b, run p (a ++ b) = run (run p a) b.
Proof. intros. apply fold_left_app. Qed.

Lemma moves_only : forall p now dt n, moves p now dt n ->
  stopped p = false /\ exists r ttl, may_follow p r ttl /\ within_deadline now r ttl = true.
Proof.
  intros [last dl st] now dt n H. unfold moves, active, should_hold, may_follow in *. simpl in *.
  destruct dl as [(r, ttl)|]; simpl in H; [|congruence].
  destruct (within_deadline now r ttl) eqn:W; simpl in H; [|congruence].
  destruct st; simpl in H; [congruence|]. eauto.
Qed.

(** Latched is latched. *)
Lemma stopped_step : forall p i, stopped p = true -> i <> Reset -> stopped (step p i) = true.
Proof.
  intros [last dl st] i H N. simpl in H. subst st. destruct i as [m now ttl q|now dt n| |]; simpl; try reflexivity; try congruence.
  - destruct m; simpl; try reflexivity.
    + destruct (hold_takes_effect last q); reflexivity.
    + destruct (advances last q); reflexivity.
    + destruct (hold_takes_effect last q); reflexivity.
  - unfold active, should_hold. simpl. destruct dl as [(r, ttl)|]; [|reflexivity].
    destruct (within_deadline now r ttl); reflexivity.
Qed.

(** Held is held, until a command that advances is accepted. *)
Lemma held_step : forall p i, deadline p = None -> ~ accepts p i -> deadline (step p i) = None.
Proof.
  intros [last dl st] i H N. simpl in H. subst dl. destruct i as [m now ttl q|now dt n| |]; simpl in *; try reflexivity.
  destruct m; simpl; try reflexivity.
  - destruct (hold_takes_effect last q); reflexivity.
  - destruct (advances last q); simpl; [now elim N|reflexivity].
  - destruct (hold_takes_effect last q); reflexivity.
Qed.

(** What a plant does with an input that leaves it following the same command. *)
Definition keeps (p : plant S Q) (i : input) (r ttl : num) : Prop :=
  match i with
  | Command Active _ _ q => advances (last_seq p) q = false
  | Command (Init | Hold) _ _ q => hold_takes_effect (last_seq p) q = false
  | Command Estop _ _ _ | Stop => True
  | Ask now _ _ => within_deadline now r ttl = true
  | Reset => False
  end.

(** Where a deadline comes from: the input set it, or the plant had it before and the input keeps it. *)
Lemma deadline_step : forall p i r ttl, may_follow (step p i) r ttl ->
  (exists q, i = Command Active r ttl q /\ advances (last_seq p) q = true) \/ (may_follow p r ttl /\ keeps p i r ttl).
Proof.
  intros [last dl st] i r ttl H. unfold may_follow in *. destruct i as [m now t q|now dt n| |]; simpl in *.
  - destruct m; simpl in *.
    + destruct (hold_takes_effect last q); simpl in *; [discriminate|auto].
    + destruct (advances last q) eqn:A; simpl in *; [left|right; auto]. injection H as <- <-. eauto.
    + destruct (hold_takes_effect last q); simpl in *; [discriminate|auto].
    + auto.
  - right. unfold active, should_hold in H. simpl in H. destruct dl as [(r', ttl')|]; simpl in H; [|discriminate].
    destruct (within_deadline now r' ttl') eqn:W; simpl in H; [|discriminate].
    destruct st; simpl in H; [injection H as <- <-; auto|].
    destruct dt as [dt|]; simpl in H; [|injection H as <- <-; auto].
    destruct (negb (Nat.eqb n 0) && is_duration dt)%bool; simpl in H; [|injection H as <- <-; auto].
    destruct (Nat.ltb _ _) in H; simpl in H; [discriminate|injection H as <- <-; auto].
  - auto.
  - discriminate.
Qed.

(** All inputs of a trace keep the command of [r] and [ttl]. *)
Fixpoint kept_by (p : plant S Q) (trace : list input) (r ttl : num) : Prop :=
  match trace with
  | [] => True
  | i :: rest => keeps p i r ttl /\ kept_by (step p i) rest r ttl
  end.

Lemma kept_by_app : forall trace p more r ttl,
  kept_by p trace r ttl -> kept_by (run p trace) more r ttl -> kept_by p (trace ++ more) r ttl.
Proof. induction trace as [|i trace IH]; simpl; intros p more r ttl A B; [exact B|]. split; [tauto|]. apply IH; tauto. Qed.

Lemma deadline_origin : forall trace r ttl, may_follow (run new_plant trace) r ttl ->
  exists before q after, trace = before ++ Command Active r ttl q :: after /\
    advances (last_seq (run new_plant before)) q = true /\
    kept_by (run new_plant (before ++ [Command Active r ttl q])) after r ttl.
Proof.
  intros trace. induction trace as [|i trace IH] using rev_ind; intros r ttl H; [discriminate|].
  rewrite run_app in H. simpl in H. apply deadline_step in H as [(q & -> & A)|(H & K)].
  - exists trace, q, []. simpl. auto.
  - destruct (IH r ttl H) as (before & q & after & -> & A & B). exists before, q, (after ++ [i]).
    rewrite <- app_assoc. split; [reflexivity|]. split; [exact A|]. apply kept_by_app; [exact B|].
    rewrite <- run_app, <- app_assoc. simpl app at 2. simpl. split; [exact K|exact I].
Qed.

Lemma no_reset : forall trace p r ttl, kept_by p trace r ttl -> ~ In Reset trace.
Proof. induction trace as [|i trace IH]; simpl; intros p r ttl K; [tauto|]. intros [->|H]; [apply K|]. eapply IH; [apply K|exact H]. Qed.

Lemma stopped_run : forall trace p, stopped p = true -> ~ In Reset trace -> stopped (run p trace) = true.
Proof.
  induction trace as [|i trace IH]; simpl; intros p H N; [exact H|]. apply IH; [|tauto].
  apply stopped_step; [exact H|]. intros ->. tauto.
Qed.

Lemma stop_stops : forall p i, i = Stop \/ (exists now ttl q, i = Command Estop now ttl q) -> stopped (step p i) = true.
Proof. intros p i [->|(now & ttl & q & ->)]; reflexivity. Qed.

(** Nobody has stopped the plant since the last reset. *)
Lemma never_stopped : forall trace p, stopped (run p trace) = false -> ~ In Reset trace ->
  forall i, In i trace -> i <> Stop /\ forall now ttl q, i <> Command Estop now ttl q.
Proof.
  intros trace p H N i I. apply in_split in I as (before & after & ->).
  assert (X : stopped (step (run p before) i) = true -> False).
  { intros E. rewrite run_app in H. simpl in H. rewrite stopped_run in H; [discriminate|exact E|].
    intros R. apply N. apply in_or_app. right. now right. }
  split; [|intros now ttl q]; intros ->; apply X; apply stop_stops; eauto.
Qed.

(** *** The theorem

    For every sequence of commands, asks, stops and resets: where the plant moves at [now], an active command that
    advanced was accepted at some [r] with the deadline still open at [now]; since then no other has been accepted, no
    HOLD has taken effect, no ask has found the deadline closed, and no ESTOP and no reset has come. *)
Theorem plant_moves_only_when_allowed : forall trace now dt n, moves (run new_plant trace) now dt n ->
  exists before r ttl q after,
    trace = before ++ Command Active r ttl q :: after /\
    advances (last_seq (run new_plant before)) q = true /\
    within_deadline now r ttl = true /\
    stopped (run new_plant before) = false /\
    kept_by (run new_plant (before ++ [Command Active r ttl q])) after r ttl /\
    ~ In Reset after /\
    forall i, In i after -> i <> Stop /\ forall now ttl q, i <> Command Estop now ttl q.
Proof.
  intros trace now dt n H. apply moves_only in H as (St & r & ttl & D & W).
  destruct (deadline_origin trace r ttl D) as (before & q & after & -> & A & K).
  exists before, r, ttl, q, after. pose proof (no_reset _ _ _ _ K) as N.
  assert (X : run new_plant (before ++ Command Active r ttl q :: after) =
    run (run new_plant (before ++ [Command Active r ttl q])) after).
  { rewrite <- run_app, <- app_assoc. reflexivity. }
  rewrite X in St. repeat split; try assumption.
  - destruct (stopped (run new_plant before)) eqn:E; [|reflexivity]. rewrite stopped_run in St; [discriminate| |exact N].
    rewrite run_app. apply (stopped_step (run new_plant before) (Command Active r ttl q) E). discriminate.
  - now apply (never_stopped after _ St N i).
  - now apply (never_stopped after _ St N i).
Qed.

(** Latch: from an ESTOP on, whatever comes but a reset, nothing moves. *)
Theorem latch_stays : forall before i after now dt n,
  i = Stop \/ (exists now ttl q, i = Command Estop now ttl q) -> ~ In Reset after ->
  ~ moves (run new_plant (before ++ i :: after)) now dt n.
Proof.
  intros before i after now dt n I N M. apply moves_only in M as (St & _). rewrite run_app in St. simpl in St.
  rewrite stopped_run in St; [discriminate|now apply stop_stops|exact N].
Qed.

(** No input of the trace accepts a command that advances. *)
Fixpoint none_accepted (p : plant S Q) (trace : list input) : Prop :=
  match trace with
  | [] => True
  | i :: rest => ~ accepts p i /\ none_accepted (step p i) rest
  end.

Lemma held_run : forall trace p, deadline p = None -> none_accepted p trace -> deadline (run p trace) = None.
Proof.
  induction trace as [|i trace IH]; simpl; intros p H N; [exact H|]. apply IH; [|tauto]. apply held_step; tauto.
Qed.

Lemma ask_holds : forall p now dt n, snd (active p now dt n) = None -> stopped p = false ->
  deadline (step p (Ask now dt n)) = None.
Proof.
  intros [last dl st] now dt n H St. simpl in *. subst st. unfold active, should_hold in *. simpl in *.
  destruct dl as [(r, ttl)|]; simpl in *; [|reflexivity].
  destruct (within_deadline now r ttl) eqn:W; simpl in *; [|reflexivity].
  destruct dt as [dt|]; simpl in *; [|discriminate].
  destruct (negb (Nat.eqb n 0) && is_duration dt)%bool eqn:E; simpl in *; [|discriminate].
  destruct (Nat.ltb _ _) eqn:L; simpl in *; [reflexivity|discriminate].
Qed.

(** Hold: an ask that is answered with nothing keeps the plant held, whatever the clock reads then, until a command that
    advances is accepted; and with the latch even then. *)
Theorem hold_persists : forall before now dt n after now' dt' n',
  snd (active (run new_plant before) now dt n) = None ->
  none_accepted (run new_plant (before ++ [Ask now dt n])) after ->
  ~ In Reset after ->
  ~ moves (run new_plant (before ++ Ask now dt n :: after)) now' dt' n'.
Proof.
  intros before now dt n after now' dt' n' H N R M.
  assert (X : run new_plant (before ++ Ask now dt n :: after) = run (run new_plant (before ++ [Ask now dt n])) after).
  { rewrite <- run_app, <- app_assoc. reflexivity. }
  rewrite X in M. apply moves_only in M as (St & r & ttl & D & _).
  destruct (stopped (run new_plant before)) eqn:E.
  - rewrite stopped_run in St; [discriminate| |exact R]. rewrite run_app.
    apply (stopped_step (run new_plant before) (Ask now dt n) E). discriminate.
  - unfold may_follow in D. rewrite held_run in D; [discriminate| |exact N]. rewrite run_app.
    now apply (ask_holds (run new_plant before) now dt n H E).
Qed.

End Traces.
