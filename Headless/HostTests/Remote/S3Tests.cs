using Amazon.S3;
using Amazon.S3.Model;
using FastPoints.Cli.Sources;

namespace FastPoints.HostTests.Remote;

/// <summary>s3:// of the command line, against a server that checks signatures (s3rver, whose keys are known).</summary>
[NonParallelizable]
sealed class S3Tests : RemoteFixture
{
    const string Bucket = "clouds";

    S3Server m_server;

    [SetUp]
    public void Begin()
    {
        m_server = S3Server.Start(Scratch["s3"], Bucket);
        RemoteSettings.Current = new RemoteSettings();
    }

    [TearDown]
    public void End()
    {
        (RemoteAccess.Sign, S3Addresses.Lifetime) = (null, TimeSpan.FromHours(1));
        m_server?.Dispose();
        m_server = null;
    }

    string[] Reads => m_server.Log.Where(l => l.Contains(" 206 ") || l.Contains(" 403 ")).ToArray();

    static void Put(string file, string key)
    {
        using var s3 = new AmazonS3Client();
        using var client = new HttpClient();
        string address = s3.GetPreSignedURL(new GetPreSignedUrlRequest
        {
            BucketName = Bucket,
            Key = key,
            Expires = DateTime.UtcNow.AddMinutes(5),
            Verb = HttpVerb.PUT,
            Protocol = Protocol.HTTP,
        });
        Assert.That(client.PutAsync(address, new ByteArrayContent(File.ReadAllBytes(file))).Result.IsSuccessStatusCode);
    }

    // With a cache of its own: s3rver does not know the range of the first byte, by which a version is checked.
    CliCall Call(params string[] args)
    {
        RemoteAccess.CacheFolder = Scratch["cache" + Guid.NewGuid()];
        StartAnew();
        var call = CliCall.Of([.. args, "--json", "-", "--quiet", "--force"]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Output + call.Error, Does.Not.Contain("X-Amz"));
        return call;
    }

    [Test]
    public void Verbs_OfAnObject_GiveWhatTheDiskGives()
    {
        string las = Scratch.Demo("a b.las", 60_000);
        Put(las, "town/a b+ü.las");
        const string Address = "s3://" + Bucket + "/town/a b+ü.las";

        Assert.That(Call("info", "--scan", Address).Json.GetProperty("points").GetInt64(), Is.EqualTo(60_000));
        Call("picture", las, "--size", "160x120", "-o", Scratch["here.png"]);
        Call("picture", Address, "--size", "160x120", "-o", Scratch["there.png"]);
        Assert.That(File.ReadAllBytes(Scratch["there.png"]), Is.EqualTo(File.ReadAllBytes(Scratch["here.png"])));
        Call("convert", Address, "-o", Scratch["there.fastpoints"]);
        Assert.That(Call("verify", Scratch["there.fastpoints"], "--against", Address).Json.GetProperty("ok").GetBoolean());
        Assert.That(Reads, Is.Not.Empty.And.All.Contains("X-Amz-Signature").And.All.Contains(" 206 "));
    }

    [Test]
    public void Picture_OfAConvertedCloud_SignsEachOfItsFiles()
    {
        string cloud = Scratch.Converted(points: 60_000);
        foreach (string file in Directory.GetFiles(cloud, "*", SearchOption.AllDirectories))
            Put(file, "town.fastpoints/" + Path.GetRelativePath(cloud, file));
        Call("picture", cloud, "--size", "160x120", "-o", Scratch["here.png"]);
        Call("picture", $"s3://{Bucket}/town.fastpoints", "--size", "160x120", "-o", Scratch["there.png"]);
        Assert.That(File.ReadAllBytes(Scratch["there.png"]), Is.EqualTo(File.ReadAllBytes(Scratch["here.png"])));
        Assert.That(Reads, Is.Not.Empty.And.All.Contains("X-Amz-Signature"));
    }

    [Test]
    public void Read_AfterTheSignaturesTime_IsSignedAnew()
    {
        string las = Scratch.Demo("scan.las", 60_000);
        Put(las, "scan.las");
        S3Addresses.Lifetime = TimeSpan.FromSeconds(1);
        string address = S3Addresses.Resolve([$"s3://{Bucket}/scan.las"])[0];
        RemoteFile file = RemoteFile.Open(address);
        // Ranges that nobody has read yet, until one comes too late for its signature.
        for (int at = 500_000; !Reads.Any(l => l.Contains(" 403 ")); at += 16)
            Read(file, at, 16);
        Assert.That(Read(file, 1_000_000, 100_000).AsSpan().SequenceEqual(File.ReadAllBytes(las).AsSpan(1_000_000, 100_000)));
        Assert.That(Reads.Count(l => l.Contains(" 403 ")), Is.EqualTo(1));
    }

    [Test]
    public void Info_WithoutABucketKeyOrRegion_IsAUsageError()
    {
        Assert.That(CliCall.Of("info", "s3://clouds").Error, Does.Contain("wanted s3://bucket/key"));
        S3Server.Set(null, null, null, null);
        var call = CliCall.Of("info", "s3://clouds/a.las");
        Assert.That(call.Error, Does.Contain("AWS_REGION"));
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage));
    }

    // In a process of its own: the SDK remembers credentials.
    [Test]
    public void Info_WithoutCredentials_AsksUnsignedAndSaysSoWhereItIsRefused()
    {
        S3Server.Set(Server.Address, "eu-west-1", null, null);
        Directory.CreateDirectory(Scratch["served/clouds"]);
        Scratch.Demo("served/clouds/scan.las", 5000);
        (int Status, string Error) Info()
        {
            var start = new ProcessStartInfo(Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli"),
                ["info", "s3://clouds/scan.las"])
            {
                RedirectStandardError = true,
                RedirectStandardOutput = true,
            };
            (start.Environment["HOME"], start.Environment["AWS_EC2_METADATA_DISABLED"]) = (Scratch.Root, "true");
            using var process = Process.Start(start);
            process.StandardOutput.ReadToEnd();
            string error = process.StandardError.ReadToEnd();
            process.WaitForExit();
            return (process.ExitCode, error);
        }
        Assert.That(Info().Status, Is.EqualTo(ExitStatus.Done));
        Server.Plan = _ => Fault.Refused403;
        Assert.That(Info().Error, Does.EndWith("permission denied; no credentials of AWS were found\n"));
        Assert.That(Server.Requests, Is.Not.Empty.And.None.Matches<RangeRequest>(r => r.Target.Contains('?')));
    }
}
