"""What gRPC's own tools expect of a server: health and reflection."""

import google.protobuf.descriptor_pool
from google.protobuf import message_factory
from grpc_health.v1 import health_pb2, health_pb2_grpc
from grpc_reflection.v1alpha.proto_reflection_descriptor_database import ProtoReflectionDescriptorDatabase


def test_the_server_says_that_it_is_healthy(channel):
    health = health_pb2_grpc.HealthStub(channel)
    for name in ["", "trajan.v1.Jobs"]:
        answer = health.Check(health_pb2.HealthCheckRequest(service=name))
        assert answer.status == health_pb2.HealthCheckResponse.SERVING


def test_the_public_service_is_listed(channel):
    assert "trajan.v1.Jobs" in ProtoReflectionDescriptorDatabase(channel).get_services()


def test_a_client_without_any_schema_can_check_a_scene(channel):
    pool = google.protobuf.descriptor_pool.DescriptorPool(ProtoReflectionDescriptorDatabase(channel))
    method = pool.FindServiceByName("trajan.v1.Jobs").methods_by_name["CheckScene"]
    factory = message_factory.MessageFactory(pool)
    request_class = factory.GetPrototype(method.input_type)
    response_class = factory.GetPrototype(method.output_type)
    call = channel.unary_unary("/trajan.v1.Jobs/CheckScene", request_class.SerializeToString,
                               response_class.FromString)
    request = request_class()
    request.scene.name = "nothing but a name"
    paths = [violation.path for violation in call(request).violations]
    assert "analysis.end_time" in paths and "name" in paths
