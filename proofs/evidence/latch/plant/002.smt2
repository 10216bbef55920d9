; latch/plant: init = model.init; ∀ σ ∈ (I64 ∪ {none}) × (F64² ∪ {none}) × {0, 1}, events e: step(σ, e) = model.step(σ, e), answer and every member of the state, bit by bit; active = k ⇒ k ≤ (age ⊘ dt) < k + 1 ∧ k ≤ n
; Each answer has to be unsat, 223 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const q0 (_ BitVec 64))
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
(define-fun t35 () Bool (and t19 t20))
(define-fun t36 () Bool (and t21 t35))
(define-fun t37 () Bool (and t16 t36))
(define-fun t38 () Bool (and t25 t37))
(define-fun t39 () Bool (and t26 t38))
(define-fun t41 () Float64 (fp.div RNE t24 x3))
(define-fun t42 () Bool (fp.lt t41 (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t44 () Bool (fp.leq (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t41))
(define-fun t45 () Bool (and t42 t44))
(define-fun t47 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t48 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x3))
(define-fun t49 () Bool (and t47 t48))
(define-fun t50 () Bool (fp.lt t41 (fp #b0 #b10000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t52 () Bool (and t49 (not t50)))
(define-fun t54 () Bool (and t39 (not t52)))
(define-fun t57 () Bool (and (not t45) t49))
(define-fun t59 () Bool (fp.leq (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000) t41))
(define-fun t60 () Bool (and t50 t59))
(define-fun t62 () Bool (and t49 (not t60)))
(define-fun t64 () Bool (fp.lt t41 (fp #b0 #b10000000000 #b1000000000000000000000000000000000000000000000000000)))
(define-fun t66 () Bool (and t49 (not t64)))
(define-fun t68 () Bool (and t39 (not t66)))
(define-fun t70 () Bool (fp.leq (fp #b0 #b10000000000 #b0000000000000000000000000000000000000000000000000000) t41))
(define-fun t71 () Bool (and t64 t70))
(define-fun t73 () Bool (and t49 (not t71)))
(define-fun t75 () Bool (fp.lt t41 (fp #b0 #b10000000001 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t77 () Bool (and t49 (not t75)))
(define-fun t79 () Bool (and t39 (not t77)))
(define-fun t81 () Bool (fp.leq (fp #b0 #b10000000000 #b1000000000000000000000000000000000000000000000000000) t41))
(define-fun t82 () Bool (and t75 t81))
(define-fun t84 () Bool (and t49 (not t82)))
(define-fun t86 () Bool (fp.lt t41 (fp #b0 #b10000000010 #b0010000000000000000000000000000000000000000000000000)))
(define-fun t88 () Bool (and t49 (not t86)))
(define-fun t90 () Bool (and t39 (not t88)))
(define-fun t93 () Bool (fp.lt t41 (fp #b0 #b10000000001 #b0100000000000000000000000000000000000000000000000000)))
(define-fun t94 () Bool (fp.leq (fp #b0 #b10000000001 #b0000000000000000000000000000000000000000000000000000) t41))
(define-fun t95 () Bool (and t93 t94))
(define-fun t97 () Bool (and t49 (not t95)))
(define-fun t100 () Bool (fp.lt t41 (fp #b0 #b10000000001 #b1000000000000000000000000000000000000000000000000000)))
(define-fun t101 () Bool (fp.leq (fp #b0 #b10000000001 #b0100000000000000000000000000000000000000000000000000) t41))
(define-fun t102 () Bool (and t100 t101))
(define-fun t104 () Bool (and t49 (not t102)))
(define-fun t107 () Bool (fp.lt t41 (fp #b0 #b10000000001 #b1100000000000000000000000000000000000000000000000000)))
(define-fun t108 () Bool (fp.leq (fp #b0 #b10000000001 #b1000000000000000000000000000000000000000000000000000) t41))
(define-fun t109 () Bool (and t107 t108))
(define-fun t111 () Bool (and t49 (not t109)))
(define-fun t114 () Bool (fp.lt t41 (fp #b0 #b10000000010 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t115 () Bool (fp.leq (fp #b0 #b10000000001 #b1100000000000000000000000000000000000000000000000000) t41))
(define-fun t116 () Bool (and t114 t115))
(define-fun t118 () Bool (and t49 (not t116)))
(define-fun t120 () Bool (fp.leq (fp #b0 #b10000000010 #b0000000000000000000000000000000000000000000000000000) t41))
(define-fun t121 () Bool (and t86 t120))
(define-fun t123 () Bool (and t49 (not t121)))
(declare-const q1 (_ BitVec 64))
(define-fun t137 () Bool (bvslt q0 q1))
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t54))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t14))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert (not t15))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t19))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert (not t20))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert (not t21))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t25))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t50))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t26))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t50))(assert (not (not t54)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t68))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t14))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert (not t15))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t19))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert (not t20))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert (not t21))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t25))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t64))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t26))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t64))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t79))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t14))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert (not t15))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t19))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert (not t20))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert (not t21))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t25))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t75))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t26))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t75))(assert (not (not t79)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert (not t47))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert (not t48))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert (not t114))(assert t86)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert (not t114))(assert t86)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert t114)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert t114)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert t107)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert t107)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert t100)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert t100)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert t93)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert t93)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert (not t47))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert (not t48))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert (not t114))(assert t86)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert (not t114))(assert t86)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert t114)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert t114)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert t107)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert t107)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert t100)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert t100)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert t93)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert t93)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert t42)(assert (not t90))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t14))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert (not t15))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert (not t19))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert (not t20))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert (not t21))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t25))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t86))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert (not t26))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t14)(assert t15)(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t86))(assert (not (not t90)))
(check-sat)
(pop 1)
(push 1) ; only what advances counts
(assert t137)(assert (not t137))
(check-sat)
(pop 1)
(push 1) ; only what advances counts
(assert (not t137))(assert (not (not t137)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert (not t44))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t42)(assert t44)(assert t47)(assert t48)(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t47))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t47)(assert (not t48))(assert (not (not t57)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert t50)(assert (not (not t62)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert t64)(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not (not t84)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not (not t84)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not (not t84)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not (not t84)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not (not t84)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not (not t84)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not (not t84)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert t75)(assert (not (not t84)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert t93)(assert (not (not t97)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert t93)(assert (not (not t97)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert t93)(assert (not (not t97)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert t93)(assert (not (not t97)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert t100)(assert (not (not t104)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert t100)(assert (not (not t104)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert t100)(assert (not (not t104)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert t100)(assert (not (not t104)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert t107)(assert (not (not t111)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert t107)(assert (not (not t111)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert t107)(assert (not (not t111)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert t107)(assert (not (not t111)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert t114)(assert (not (not t118)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert t114)(assert (not (not t118)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert t114)(assert (not (not t118)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert t114)(assert (not (not t118)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert (not t114))(assert t86)(assert (not (not t123)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert (not t18))(assert t19)(assert t20)(assert t21)(assert t26)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert (not t114))(assert t86)(assert (not (not t123)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert (not t114))(assert t86)(assert (not (not t123)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t14)(assert t15)(assert t18)(assert t19)(assert t20)(assert t21)(assert t25)(assert t47)(assert t48)(assert t44)(assert (not t42))(assert (not t50))(assert (not t64))(assert (not t75))(assert (not t93))(assert (not t100))(assert (not t107))(assert (not t114))(assert t86)(assert (not (not t123)))
(check-sat)
(pop 1)
(push 1) ; without a horizon it is tick 0
(assert t47)(assert t48)(assert (not t49))
(check-sat)
(pop 1)
