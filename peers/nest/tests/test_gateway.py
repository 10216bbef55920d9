"""The five model families through the gateway, by clients whose Zenoh and WebSocket are not the project's own."""

import pytest
import through
from conftest import ANSWER_S, clients
from test_families import FAMILIES, assert_is_nest_driven_directly, opened


@pytest.fixture(scope="module")
def gateway(request, service):
    program = request.config.getoption("--gateway")
    if program is None:
        pytest.skip("no --gateway is given")
    with through.gateway(program, service.address, ANSWER_S) as addresses:
        yield dict(zip(("zenoh", "websocket"), addresses, strict=True))


@pytest.fixture(params=["zenoh", "websocket"])
def client(request, gateway):
    over = {"zenoh": through.over_zenoh, "websocket": through.over_websocket}[request.param]
    with over(gateway[request.param], ANSWER_S) as ask, clients(ask) as make:
        yield make


@pytest.mark.parametrize("model", FAMILIES)
def test_through_the_gateway_a_family_is_nest_driven_directly(client, model):
    assert_is_nest_driven_directly(opened(client, model), model)
