from lib import *
from judge import J
import re,sys,pickle
from collections import Counter,defaultdict
# (regex of id, [bases]) ; 'add' appended after the present ones, unless front
PASSES='safety/gates/nothing/active'
PR=[
# cause, regex, bases
('codec',r'codec/encode/range/([\w-]+)/(?:below|above)/(.*)',[r'codec/encode/range/\1/quarter/\2']),
('codec',r'codec/decode/range/([\w-]+)/(?:below|above)/(.*)',[r'codec/decode/range/\1/quarter/\2']),
('codec',r'codec/encode/uav/[xyz]-only$',['codec/encode/range/uav/quarter/to-0-200']),
('codec',r'codec/encode/(?:uav|missing)/',['codec/encode/uav/x-only','codec/encode/uav/y-only','codec/encode/uav/z-only']),
('codec',r'codec/encode/ignored/',['codec/encode/range/default/quarter/to-0-200']),
('codec',r'codec/decode/uav/(?:[xyz]-only|ends|other-ends)$',['codec/decode/range/default/quarter/to-2-6']),
('codec',r'codec/decode/uav/',['codec/decode/uav/ends','codec/decode/uav/y-only','codec/decode/uav/z-only']),
('codec',r'codec/decode/mapping/',['codec/decode/range/default/quarter/to-2-6']),
('reflex',r'control/reflex/default/',['control/reflex/law/moving/damped','control/reflex/law/far/no-gain','control/reflex/law/far/stiff']),
('reflex',r'control/reflex/velocity/',['control/reflex/default/max-speed','control/reflex/law/far/stiff']),
('loop',r'control/loop/gate/fence-inside$',['control/reflex/law/x/defaults','control/reflex/default/max-speed',PASSES,'safety/projection/path/straight']),
('loop',r'control/loop/(?:link|gate|newest|ttl|status)/',['control/loop/gate/fence-inside']),
('loop',r'control/loop/gate/stale',['safety/stale/age/500-ms/from-0-s/exact']),
('loop',r'control/loop/(?:gate/(?:stale|clock|outside)|ttl/look|link/burst|newest/(?:no-|echo-held))',['safety/zeroing/channels/units/no-position','safety/zeroing/channels/negative/no-position']),
('loop',r'control/loop/(?:newest/(?:.*renews|restarted|echo-held)|link/burst|ttl/look|gate/outside)',['control/loop/gate/stale']),
('loop',r'control/loop/link/burst-clears',['control/loop/link/burst','control/loop/gate/outside-reset']),
('loop',r'control/loop/(?:link/burst|status/.*burst)',['control/loop/link/fast-sensor']),
('loop',r'control/loop/(?:gate/outside|link/burst-clears)',['safety/latch/sequence/burst-calm-reset','safety/latch/sequence/burst-reset-reset']),
('link',r'control/loop/newest/restarted',['resilience/link/count/before-first']),
('link',r'control/loop/link/fast-sensor',['resilience/link/count/one-gap']),
('link',r'resilience/link/extreme/(.*)/and-back$',[r'resilience/link/extreme/\1']),
('link',r'resilience/link/extreme/at-the-end',['resilience/link/count/duplicate-first']),
('link',r'resilience/link/count/(?:late-twice|rate-negative)',['resilience/link/count/late']),
('link',r'resilience/link/count/late-before',['resilience/link/count/duplicate-first']),
('link',r'resilience/link/ref-loss/',['resilience/link/burst/clears-a-small-one','resilience/link/burst/after-a-good-link']),
('strict-realm',r'strict/keys/realm/',['keys/realms/rpc/realm/second-at','keys/realms/rpc/realm/second-space','keys/realms/rpc/realm/slash-twice']),
('keys-built',r'strict/keys/.*default-realm',['keys/build/rpc/default-realm']),
('keys-built',r'keys/build/(sensor|command)/realm-of-.*-named',[r'keys/build/\1/realm-named']),
('keys-built',r'keys/realms/rpc/realm/two-of-256',['keys/build/rpc/realm','keys/build/rpc/realm-of-two']),
('keys-reported',r'keys/segments/(\w+)/(\w+)/reported/at',[r'keys/segments/\1/\2/refused/at-first']),
('keys-reported',r'keys/segments/(\w+)/(\w+)/reported/space',[r'keys/segments/\1/\2/refused/space-inside',r'keys/segments/\1/\2/refused/space-first']),
('matching',r'keys/matching/(?!ncp-rpc/)',['keys/matching/ncp-rpc/ncp-rpcs']),
('matching',r'keys/matching/(?:starstar-ata|ata-starstar)',['keys/matching/starstar/ncp-rpc']),
('deadline',r'resilience/watchdog/ttl-250/from-0/double',[]),
('deadline',r'resilience/(?:liveness/|watchdog/(?:seq|capped|trace)/)',['resilience/watchdog/ttl-250/from-0/double','resilience/watchdog/ttl-250/from-0/exact']),
('deadline',r'resilience/buffer/senders-clock/',['resilience/watchdog/ttl-250/from-0/exact']),
('plant-accepts',r'resilience/horizon/trace/(?:older|duplicate)',['resilience/buffer/drop/duplicate/deadline']),
('plant-accepts',r'strict/plant/(?:reset/replay|stream/falling|dropped/active/equal)',['strict/plant/dropped/active/older','strict/plant/dropped/hold/equal']),
('plant-accepts',r'resilience/liveness/.*r',['resilience/watchdog/trace/reset-then-same']),
('hold-then',r'resilience/buffer/hold/(?!seq-zero|equal-seq|newer-seq)',['resilience/buffer/hold/newer-seq/hold','resilience/buffer/hold/newer-seq/init','resilience/buffer/hold/equal-seq/hold','resilience/buffer/hold/seq-zero/hold']),
('hold-then',r'strict/plant/hold/(\w+)/first',[r'strict/plant/hold/\1/advances']),
('hold-then',r'resilience/buffer/hold/zero-then-duplicate',['resilience/buffer/hold/equal-then-duplicate/hold']),
('horizon',r'resilience/horizon/(?:trace/|odd-length)',['resilience/horizon/tick/250-ms/1-steps/tick-1/start','resilience/horizon/tick/250-ms/1-steps/tick-2/start']),
('plant-reset',r'(?:resilience/buffer/reset/restart|strict/plant/reset/)',['resilience/buffer/reset/moving']),
('config',r'safety/(?:gates/(?:config-fault|unbound-limit|order)/|latch/config/)',['safety/binding/value/fence/minus-1.0','safety/binding/undeclared/nothing/fence']),
('governor-trace',r'safety/fence/channel/',['safety/fence/outside/3-4-0/octant-0']),
('governor-trace',r'safety/binding/by-name/',['safety/fence/outside/3-4-0/octant-0']),
('governor-trace',r'safety/(?:together|latch/config)/',['safety/latch/sequence/burst-reset-reset']),
('governor-trace',r'safety/together/fault/',['safety/latch/config/negative-fence/reset']),
('governor-trace',r'safety/together/kept/calm',['safety/gates/latched-by-link/active']),
('projection',r'safety/projection/(?:negotiated|horizon/just)',['safety/projection/path/up','safety/projection/horizon/along-z','safety/projection/horizon/diagonal','safety/projection/velocity/no-channels','safety/projection/step/no-channels-at-3']),
('projection',r'safety/together/',['safety/projection/horizon/along-z']),
('projection',r'safety/(?:zeroing/.*leaves-fence)',['safety/projection/path/up','safety/projection/horizon/along-z','safety/projection/velocity/no-channels','safety/projection/step/no-channels-at-3']),
('projection',r'control/loop/ttl/look',['safety/projection/path/up']),
('projection',r'safety/together/kept/truncated',['safety/projection/path/up']),
('speed',r'safety/(?:speed/(?!vector)|binding/|fence/tilt|together/)',['safety/speed/vector/1-0-0/below']),
('speed',r'safety/speed/channel/(.*)-beside-a-clamp',[r'safety/speed/channel/\1']),
('speed',r'safety/projection/clamped-horizon',['safety/speed/vector/3-4-0/above']),
('zeroing',r'safety/zeroing/.*hold-command',['safety/gates/mode/hold/fence/slow','safety/gates/mode/hold/both/slow']),
('zeroing',r'safety/zeroing/channels/(?:all|some|none|others|negative)/',['safety/zeroing/channels/units/no-position']),
('session-trace',r'session/life/version/.*leaves-nothing',['session/life/life/step-before-open','session/life/life/close-unknown']),
('session-trace',r'session/life/life/(?:in-order|reopen|close-twice)',['session/life/life/time-since-opened','session/life/life/step-after-close']),
('session-trace',r'strict/server/',['session/life/advance/1','session/life/life/time-since-opened']),
('session-trace',r'session/life/life/step-before-open',['session/life/chunk/5']),
('session-trace',r'session/life/fails/',['session/life/life/two-apart']),
('session-trace',r'session/life/malformed/(?!array)',['session/life/malformed/array']),
('session-trace',r'session/life/malformed/',['hostile/structure/close_session/behind/brace']),
('reference',r'session/(?:reference/(?:stimulus|reach|id)|life/fails)/',['session/reference/potential/defaults/dt-1','session/reference/potential/long-rest/dt-1']),
('reference',r'session/reference/(?:spikes|cadence/over)',['session/reference/port/none']),
('reference',r'session/(?:reference/(?:stimulus|reach)|life/fails)/',['session/reference/cadence/5-by-10']),
('reference',r'session/life/fails/',['session/reference/stimulus/ends/chunk-5','session/reference/rate/mu/dt-1']),
('strict-kept',r'strict/plant/kept/version-([\w-]+)/newer',[r'strict/plant/first/version-\1']),
('strict-cleared',r'strict/plant/(?:dropped|version|stream|reset|first|hold)/',['strict/plant/kept/seq-equal','strict/plant/kept/seq-zero']),
('version-guard',r'version/guard/lenient/(?:no-minor$|minor-wraps|large)',['version/guard/lenient/newer-minor','version/guard/lenient/older-minor']),
('version-guard',r'version/guard/lenient/(?:major-wraps|large)',['version/guard/lenient/next-major']),
('version-guard',r'version/guard/strict/(?:minor-wraps|major-wraps|large)',['version/guard/strict/older-minor']),
('version-guard',r'version/negotiate/compatible/(?:empty|upper)',['version/negotiate/compatible/older-hash']),
('encode',r'wire/encode_(\w+?)/(?!plain)',[r'wire/encode_\1/plain']),
('encode',r'wire/encode_error/(?:with|without)',['wire/encode_close_session/plain']),
('encode',r'(?:wire|hostile|strict/frames)/(?!encode)',['{EXPL}']),
('decode',r'session/(?:reference|life/fails)/',['wire/stimulus_in_request/step_request/without/anything']),
('decode',r'resilience/buffer/mode/moves',['wire/command_frame/explicit','wire/command_frame/horizon_dt_ms/null']),
('decode',r'safety/stale/age/500-ms/from-0-s/half',['wire/command_frame/explicit','wire/command_frame/horizon_dt_ms/null']),
('decode',r'session/life/advance/1',['wire/open_session/explicit','wire/step_request/explicit']),
('decode',r'session/life/chunk/5',['wire/open_session/explicit','wire/step_request/explicit']),
]
alone={}
def prep():
    for m in M:
        named={x['rule'] for x in m['named']}|set(m['rules'])
        a={}
        for k_,s in fails[m['name']].items():
            c=bykey.get(k_)
            if not c: continue
            sy=symptoms(c,s) or [('value','?')]
            opts=[charge1(c,k2,pp) for k2,pp in sy]
            a[c['id']]=next((r for r in opts if r in named),opts[0])
        alone[m['name']]=a
prep()
def rests(PRS):
    R={}
    cp=[(re.compile(rx),bs) for _,rx,bs in PRS]
    for i,c in cases.items():
        l=list(c.get('rests_on',[]))
        for rx,bs in cp:
            mm=rx.match(i)
            if not mm: continue
            for b_ in bs:
                if b_=='{EXPL}': continue
                t=mm.expand(b_) if '\\' in b_ else b_
                if t in cases and t!=i and t not in l: l.append(t)
        R[i]=l
    return R
sys.setrecursionlimit(10000)
SHOULD=set()
def run(Rs):
    res={}
    for m in M:
        a=alone[m['name']]; memo={}
        def f(i,stack):
            if i in memo: return memo[i]
            if i in stack: return None
            r=None
            for b_ in Rs[i]:
                if b_ in a and b_ not in stack:
                    r=f(b_,stack|{i}) or a[b_]; break
            if not stack: memo[i]=r
            return r
        c=Counter(); 
        for i in a: c[f(i,frozenset()) or a[i]]+=1
        res[m['name']]=c
    return res
if __name__=='__main__':
    old=run(rests([])); new=run(rests(PR))
    left=[];lost=[];newpairs=[]
    byc=defaultdict(lambda:[0,0])
    for m in M:
        n=m['name']
        for x in m['named']:
            r=x['rule']
            if r in m['rules']: continue
            v=J[n][r]
            if isinstance(v,str): continue
            byc[v[0]][0]+=1
            if new[n].get(r): left.append((v[0],n,r,new[n][r],x['cases']))
            else: byc[v[0]][1]+=1
        lr=[r for r in m['rules'] if old[n].get(r) and not new[n].get(r)]
        if lr: lost.append((n,lr,[r for r in m['rules'] if new[n].get(r)]))
        for r in new[n]:
            if not old[n].get(r): newpairs.append((n,r,new[n][r]))
    print({k_:v for k_,v in byc.items()})
    print(len(left)); 
    for l in left: print('LEFT',l)
    print('LOST',lost); print('NEW',newpairs)
