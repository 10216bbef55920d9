import sim
from sim import *
PR2=[(c,rx,[b_ for b_ in bs if b_!='safety/zeroing/channels/units/no-position'] if rx.startswith('safety/zeroing/channels') else bs) for c,rx,bs in PR]
PR2=[p for p in PR2 if p[2]]
PR2+=[
('bulk-values',r'bulk/values/unaligned/i32',['bulk/values/i32-plain']),
('bulk-values',r'bulk/header/golden',['bulk/values/layout/unsorted-names']),
('bulk-pack',r'bulk/observation/pack/',['bulk/observation/pack/empty']),
('bulk-pack',r'bulk/observation/pack/golden',['bulk/observation/pack/times-and-senders']),
('bulk-unpack',r'bulk/observation/unpack/(?:order/|times-)',['bulk/observation/unpack/all-three']),
('reflex',r'control/loop/ttl/look',['control/reflex/law/far/stiff','control/reflex/default/max-speed']),
('loop',r'control/loop/',['safety/stale/age/500-ms/from-0-s/half']),
('loop',r'control/loop/gate/config',['safety/zeroing/channels/units/no-position','safety/zeroing/channels/negative/no-position']),
('zeroing',r'safety/zeroing/.*hold-command',['safety/gates/mode/init/fence/slow']),
('projection',r'safety/projection/horizon/(?:first-step-leaves-tick-0-leaves|trunc)',['safety/projection/horizon/first-step-leaves-tick-0-stays','safety/projection/horizon/along-z']),
('projection',r'safety/together/horizon/kept',['safety/projection/horizon/first-step-leaves-tick-0-stays']),
('reference',r'session/reference/(?:reach|stimulus)',['session/reference/cadence/2-by-1','session/reference/cadence/5-by-1']),
('version-guard',r'version/guard/lenient/minor-',['version/guard/lenient/newer-minor','version/guard/lenient/older-minor']),
('version-guard',r'version/guard/strict/minor-',['version/guard/strict/older-minor']),
('decode',r'resilience/buffer/(?:drop/wrapped|replace/largest)',['wire/command_frame/seq/integer-largest','wire/numbers/command_frame/seq/integer-largest']),
('decode',r'(?:session/life/fails/rate|codec/encode/uav/(?:far|largest)|safety/stale/timeout|safety/binding/value/.*1e308|resilience/horizon/odd|control/loop/gate/speed-clamp)',['wire/numbers/run_request/duration_ms/double-ten-to-23']),
('encode',r'wire/encode_link_status/(?!plain|last_seq/zero)',['wire/encode_link_status/last_seq/zero']),
('encode',r'wire/encode_session_opened/(?!plain|resolved/zero)',['wire/encode_session_opened/resolved/zero']),
('encode',r'wire/encode_open_session/(?!plain|sim/seed/zero)',['wire/encode_open_session/sim/seed/zero']),
('encode',r'wire/encode_capabilities/(?!plain|sensor_channels/size/zero)',['wire/encode_capabilities/sensor_channels/size/zero']),
('encode',r'hostile/limits/(\w+?)/',[r'wire/encode_\1/seq/zero',r'wire/encode_\1/explicit']),
('encode',r'wire/encode_command_frame/(?!plain|horizon/plain)',['wire/encode_command_frame/horizon/plain-maps']),
('encode',r'(?:wire|hostile)/.*command_frame.*(?:horizon|not-wrapped)',['wire/encode_command_frame/horizon/plain-maps']),
('decode',r'hostile/limits/(\w+?)/depth',[r'wire/members/\1/unknown-member']),
('decode',r'wire/members/(\w+?)/unknown-name',[r'wire/members/\1/unknown-member']),
('encode',r'hostile/encoding/(\w+?)/string',[r'wire/encode_\1/string']),
('encode',r'wire/session_id/(\w+?)/(?:free|accepted)',[r'wire/encode_\1/string']),
('encode',r'wire/(\w+)/(?:explicit|minimal)',[r'wire/encode_\1/plain']),
('encode',r'(?:wire|strict/frames|wire/members)/error/',['wire/encode_close_session/plain']),
('encode',r'wire/members/error/',['wire/encode_close_session/plain']),
('encode',r'session/life/life/(?:close-unknown|step-before-open)',['wire/encode_close_session/plain']),
('encode',r'(?:wire/encode_error/)',['wire/encode_close_session/plain']),
('encode',r'session/reference/port/none',['wire/encode_observation_frame/explicit']),
('encode',r'safety/(?:zeroing|numbers|fence/tilt)',['wire/encode_command_frame/channels/order-of-letters']),
('defaults',r'wire/members/(\w+?)/other-case-alone/(\w+)$',[r'wire/\1/\2/absent']),
('defaults',r'strict/frames/(\w+?)/version/terse',['wire/command_frame/mode/absent',r'wire/\1/contract_hash/absent',r'wire/\1/minimal']),
('defaults',r'strict/frames/command_frame/stamp/.*/absent',['wire/command_frame/mode/absent']),
('mode',r'resilience/buffer/mode/not-estop',['resilience/estop/does-not-latch/mode-in-capitals/first','wire/command_frame/mode/unknown-novel']),
('mode',r'strict/plant/hold/unknown',['wire/command_frame/mode/unknown-novel']),
('mode',r'strict/plant/hold/absent',['wire/command_frame/mode/absent']),
('mode',r'wire/encode_\w+?/mode/novel',['wire/command_frame/mode/unknown-novel']),
('stimulus-fits',r'wire/stimulus_in_request/(\w+?)/fits/version-where',[r'wire/\1/minimal',r'wire/\1/ncp_version/absent']),
('stimulus-fits',r'wire/stimulus_in_request/(\w+?)/fits/other-session',[r'wire/session_id/\1/accepted/no-break-space']),
('stimulus-fits',r'wire/stimulus_in_request/(\w+?)/fits/other-version',[r'wire/\1/ncp_version/value']),
('decode',r'hostile/limits/observation_frame/numbers',['hostile/limits/observation_frame/size/beyond-1-mib']),
]
# overrides of what decides: (regex, rules-first or by)
for i,c in cases.items():
    if i=='codec/encode/defaults/2.0': c['requirements']=['NCP-CODEC-002','NCP-CODEC-001']
    if i.startswith('safety/binding/value/') and isinstance(c['args'].get('steps'),list) and c['requirements'][0]=='NCP-SAFE-013': c.setdefault('by',{})['/steps/1']='NCP-SAFE-018'
    if i.startswith('safety/zeroing/channels/') and c['requirements'][0]=='NCP-SAFE-071':
        c.setdefault('by',{}).update({'/steps/*/frame/channels/*/data':'NCP-SAFE-072','/steps/*/frame/channels/*/data/*':'NCP-SAFE-071'})
    if i.startswith('session/reference/') and c['requirements'][0] in('NCP-SESS-050','NCP-SESS-053') and 'by' in c:
        own=c['requirements'][0]
        c['by'].update({'/replies/*/records/*':'NCP-SESS-038','/replies/*/records/*/times':own})
        c['by'].setdefault('/replies/*/records/*/values',own)
    if i.startswith('wire/encode_') and i.endswith('seq/zero'): c.setdefault('by',{}).update({'within':'NCP-WIRE-081','/seq':'NCP-WIRE-085'})
    if i.startswith('wire/encode_'): c.setdefault('by',{}).setdefault('order','NCP-WIRE-080')
sim._pc={} if hasattr(sim,'_pc') else None
old=run(rests([])); 
prep()
R2=rests(PR2)
new=run(R2)
left=[];byc=defaultdict(lambda:[0,0]); lost=[];newp=[]
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
    if lr: lost.append((n,lr,[r for r in m['rules'] if new[n].get(r)],dict(new[n])))
    for r in new[n]:
        if not old[n].get(r): newp.append((n,r,new[n][r]))
print(dict(byc)); print(sum(a for a,_ in byc.values()),sum(b_ for _,b_ in byc.values()))
for l in left: print('LEFT',l)
for l in lost: print('LOST',l)
print('NEW',newp)
pickle.dump((dict(byc),left,lost,newp,PR2),open('sim2.pkl','wb'))
