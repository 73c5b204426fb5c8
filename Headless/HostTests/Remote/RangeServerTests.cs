namespace FastPoints.HostTests.Remote;

public class RangeServerTests
{
    [Test]
    public void Server_OfAFolder_AnswersRangesAndCountsThem()
    {
        using var folder = new ScratchFolder();
        byte[] bytes = new byte[100_000];
        new System.Random(1).NextBytes(bytes);
        File.WriteAllBytes(folder["a b.bin"], bytes);
        using var server = new RangeServer(folder.Root);
        using var client = new HttpClient();

        (HttpStatusCode Status, byte[] Body, string Range) Get(string name, long? from, long? to)
        {
            using var request = new HttpRequestMessage(HttpMethod.Get, server.Of(name));
            if (from != null || to != null)
                request.Headers.Range = new RangeHeaderValue(from, to);
            using HttpResponseMessage answer = client.Send(request);
            using var body = new MemoryStream();
            answer.Content.ReadAsStream().CopyTo(body);
            return (answer.StatusCode, body.ToArray(), answer.Content.Headers.ContentRange?.ToString());
        }

        Assert.That(Get("a%20b.bin?key=1", 10, 19).Body, Is.EqualTo(bytes[10..20]));
        Assert.That(Get("a%20b.bin", 99_990, 200_000).Range, Is.EqualTo("bytes 99990-99999/100000"));
        Assert.That(Get("a%20b.bin", null, 5).Body, Is.EqualTo(bytes[99_995..]));
        Assert.That(Get("a%20b.bin", 100_000, null).Status, Is.EqualTo(HttpStatusCode.RequestedRangeNotSatisfiable));
        Assert.That(Get("a%20b.bin", null, null).Body, Is.EqualTo(bytes));
        Assert.That(Get("b", null, null).Status, Is.EqualTo(HttpStatusCode.NotFound));
        Assert.That(server.Requests, Has.Count.EqualTo(6));
        Assert.That(server.Bytes, Is.EqualTo(10 + 10 + 5 + 100_000));
        Assert.That(server.PeakConnections, Is.EqualTo(1));
    }
}
