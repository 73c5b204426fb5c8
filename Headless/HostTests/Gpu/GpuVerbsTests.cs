namespace FastPoints.HostTests.Gpu;

public sealed class GpuVerbsTests() : GpuCloudFixture(20_000)
{
    [Test]
    public void Picture_OnTheGpu_NamesTheDeviceAndIsNearTheCpus()
    {
        string cpu = Scratch["cpu.png"], gpu = Scratch["gpu.png"];
        string style = "color=elevation,light=215,40,0.9,size=3,points=round";
        Assert.That(CliCall.Of("picture", CloudPath, "-o", cpu, "--size", "160x90", "--style", style).Status,
            Is.EqualTo(ExitStatus.Done));
        var call = CliCall.Of("picture", CloudPath, "-o", gpu, "--gpu", "--size", "160x90", "--style", style,
            "--against", cpu, "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Json.GetProperty("device").GetString(), Does.StartWith("gpu, "));
        Assert.That(call.Json.GetProperty("points").GetInt64(), Is.GreaterThan(1000));
        Assert.That(call.Json.GetProperty("psnr").GetDouble(), Is.GreaterThan(25));
    }

    [Test]
    public void Picture_OnTheGpuWithoutStyle_MatchesTheCpu()
    {
        string cpu = Scratch["c.png"], gpu = Scratch["g.png"];
        Assert.That(CliCall.Of("picture", CloudPath, "-o", cpu, "--size", "640x360").Status, Is.EqualTo(ExitStatus.Done));
        var call = CliCall.Of("picture", CloudPath, "-o", gpu, "--gpu", "--size", "640x360", "--against", cpu, "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Json.GetProperty("psnr").GetDouble(), Is.GreaterThan(38));
    }

    [Test]
    public void Fly_OnTheGpu_MatchesTheCpu()
    {
        string[] folders = { Scratch["cpu"], Scratch["gpu"] };
        for (int i = 0; i < 2; i++)
        {
            var call = CliCall.Of("fly", CloudPath, CloudPath, "--frames", "30", "--every", "15",
                "--size", "160x90", "-o", folders[i], i == 0 ? "--cpu" : "--gpu", "--style", "size=3,points=round");
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        }
        var last = folders.Select(f => Png.Read(Path.Combine(f, "last.png"))).ToArray();
        Assert.That(ImageError.Compare(last[1], last[0], new PictureOptions().Background).Psnr, Is.GreaterThan(25));
    }

    [Test]
    public void Fly_OnBoth_IsAnError() =>
        Assert.That(CliCall.Of("fly", CloudPath, "--cpu", "--gpu").Status, Is.EqualTo(ExitStatus.Usage));
}
