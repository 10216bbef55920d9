; latch/plant: init = model.init; ∀ σ ∈ (I64 ∪ {none}) × (F64² ∪ {none}) × {0, 1}, events e: step(σ, e) = model.step(σ, e), answer and every member of the state, bit by bit; active = k ⇒ k ≤ (age ⊘ dt) < k + 1 ∧ k ≤ n
; Each answer has to be unsat, 400 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const q0 (_ BitVec 64))
(define-fun t5 () Bool (= q0 (_ bv0 64)))
(declare-const x2 Float64)
(define-fun t14 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t15 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x1))
(define-fun t16 () Bool (and t14 t15))
(define-fun t18 () Bool (fp.lt x1 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t19 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t20 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t21 () Bool (fp.leq x0 x2))
(define-fun t22 () Float64 (fp.sub RNE x2 x0))
(define-fun t24 () Float64 (fp.mul RNE t22 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t25 () Bool (fp.leq t24 x1))
(define-fun t26 () Bool (fp.leq t24 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(declare-const x3 Float64)
(declare-const x4 Float64)
(define-fun t29 () Bool (not (or (fp.isNaN x4) (fp.isInfinite x4))))
(define-fun t30 () Bool (fp.leq x0 x4))
(define-fun t31 () Float64 (fp.sub RNE x4 x0))
(define-fun t32 () Float64 (fp.mul RNE t31 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t33 () Bool (fp.leq t32 x1))
(define-fun t34 () Bool (fp.leq t32 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t35 () Bool (and t19 t20))
(define-fun t36 () Bool (and t21 t35))
(define-fun t37 () Bool (and t16 t36))
(define-fun t38 () Bool (and t25 t37))
(define-fun t39 () Bool (and t26 t38))
(define-fun t41 () Float64 (fp.div RNE t24 x3))
(define-fun t42 () Bool (fp.lt t41 (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t44 () Bool (fp.leq (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t41))
(define-fun t47 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t48 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x3))
(define-fun t49 () Bool (and t47 t48))
(define-fun t50 () Bool (fp.lt t41 (fp #b0 #b10000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t52 () Bool (and t49 (not t50)))
(define-fun t54 () Bool (and t39 (not t52)))
(define-fun t64 () Bool (fp.lt t41 (fp #b0 #b10000000000 #b1000000000000000000000000000000000000000000000000000)))
(define-fun t66 () Bool (and t49 (not t64)))
(define-fun t68 () Bool (and t39 (not t66)))
(define-fun t75 () Bool (fp.lt t41 (fp #b0 #b10000000001 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t77 () Bool (and t49 (not t75)))
(define-fun t79 () Bool (and t39 (not t77)))
(define-fun t86 () Bool (fp.lt t41 (fp #b0 #b10000000010 #b0010000000000000000000000000000000000000000000000000)))
(define-fun t88 () Bool (and t49 (not t86)))
(define-fun t90 () Bool (and t39 (not t88)))
(define-fun t93 () Bool (fp.lt t41 (fp #b0 #b10000000001 #b0100000000000000000000000000000000000000000000000000)))
(define-fun t100 () Bool (fp.lt t41 (fp #b0 #b10000000001 #b1000000000000000000000000000000000000000000000000000)))
(define-fun t107 () Bool (fp.lt t41 (fp #b0 #b10000000001 #b1100000000000000000000000000000000000000000000000000)))
(define-fun t114 () Bool (fp.lt t41 (fp #b0 #b10000000010 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t131 () Bool (fp.leq x0 x3))
(define-fun t132 () Float64 (fp.sub RNE x3 x0))
(define-fun t133 () Float64 (fp.mul RNE t132 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t134 () Bool (fp.leq t133 x1))
(define-fun t135 () Bool (fp.leq t133 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(declare-const q1 (_ BitVec 64))
(define-fun t137 () Bool (bvslt q0 q1))
(define-fun t139 () Bool (= q1 (_ bv0 64)))
(define-fun t140 () Bool (bvslt q1 q0))
(define-fun t143 () Bool (and t140 (not t139)))
(define-fun t145 () Bool (and t137 (not t139)))
(define-fun t146 () Bool (= q0 q1))
(define-fun t147 () Bool (and t145 t146))
(define-fun t150 () Bool (and t145 (not t147)))
(define-fun t152 () Bool (= q1 q0))
(define-fun t153 () Bool (and (not t145) t152))
(define-fun t155 () Bool (and (not t145) (not t153)))
(push 1) ; a HOLD is never ignored
(assert (not t139))(assert t140)(assert (not t143))
(check-sat)
(pop 1)
(push 1) ; a HOLD is never ignored
(assert (not t139))(assert (not t140))(assert (not (not t143)))
(check-sat)
(pop 1)
(push 1) ; a HOLD is never ignored
(assert t139)(assert (not (not t143)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert (not t34))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert (not t34))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert (not t34))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert (not t34))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert (not t34))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert (not t34))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert (not t34))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert (not t34))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert (not t34))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert (not t34))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert t34)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert t34)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert t34)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert t34)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert t34)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert t34)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert t34)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert t34)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert t34)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t29)(assert t30)(assert t34)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert (not t135))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert (not t135))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert (not t135))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert (not t135))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert (not t135))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert (not t135))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert (not t135))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert (not t135))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert (not t135))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert (not t135))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert t135)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert t135)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert t135)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert t135)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert t135)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert t135)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert t135)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert t135)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert t135)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t131)(assert t135)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t29))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert (not t30))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert (not t33))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert (not t33))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert (not t33))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert (not t33))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert (not t33))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert (not t33))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert (not t33))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert (not t33))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert (not t33))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert (not t33))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert t33)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert t33)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert t33)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert t33)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert t33)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert t33)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert t33)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert t33)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert t33)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t29)(assert t30)(assert t33)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t131))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert (not t134))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert (not t134))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert (not t134))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert (not t134))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert (not t134))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert (not t134))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert (not t134))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert (not t134))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert (not t134))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert (not t134))(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert t134)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert t134)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert t134)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert t134)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert t134)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert t134)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert t134)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert t134)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert t134)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t131)(assert t134)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert (not t14))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert (not t15))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t19))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert (not t20))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert (not t21))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t25))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t26))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert (not t14))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert (not t15))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t19))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert (not t20))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert (not t21))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t25))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t50))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t26))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t50))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert (not t14))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert (not t15))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t19))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert (not t20))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert (not t21))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t25))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t64))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t26))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t64))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert (not t14))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert (not t15))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t19))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert (not t20))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert (not t21))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t25))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t75))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t26))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t75))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert (not t114))(assert t86)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert (not t114))(assert t86)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert t114)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert t114)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert t107)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert t107)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert t100)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert t100)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert t93)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert t93)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert (not t114))(assert t86)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert (not t114))(assert t86)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert t114)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert t114)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert t107)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert t107)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert t100)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert t100)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert t93)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert t93)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert (not t14))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert (not t15))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert (not t19))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert (not t20))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert (not t21))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t25))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t86))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t26))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; a hold persists
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t86))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert t5)(assert (not t5))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert (not t5))(assert (not (not t5)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert (not t137))(assert (not t139))(assert (not (not t150)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert (not t137))(assert t139)(assert (not (not t150)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert t137)(assert t139)(assert (not (not t150)))
(check-sat)
(pop 1)
(push 1) ; a stamped HOLD advances the stream
(assert t137)(assert (not t139))(assert (not (not t155)))
(check-sat)
(pop 1)
(push 1) ; followed unless stopped
(assert t137)(assert (not t137))
(check-sat)
(pop 1)
(push 1) ; followed unless stopped
(assert (not t137))(assert (not (not t137)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t39))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t14))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert (not t15))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t19))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert (not t20))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert (not t21))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t25))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t26))(assert (not (not t39)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t54))
(check-sat)
(pop 1)
