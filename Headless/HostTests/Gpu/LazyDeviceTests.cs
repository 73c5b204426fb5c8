namespace FastPoints.HostTests.Gpu;

public sealed class LazyDeviceTests : GraphicsFixture
{
    [TestCase(false)]
    [TestCase(true)]
    public void Picture_LoadsVulkanOnlyToDrawWithIt(bool isForGpu)
    {
        using var folder = new ScratchFolder();
        string said = Picture(folder.Demo(), folder["picture.png"], isForGpu);
        Assert.That(File.Exists(folder["picture.png"]), said);
        Assert.That(said.Contains("Vulkan Loader", StringComparison.Ordinal), Is.EqualTo(isForGpu), said);
    }

    private static string Picture(string cloud, string picture, bool isForGpu)
    {
        var start = new ProcessStartInfo(Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli"))
        {
            RedirectStandardError = true,
        };
        start.Environment["VK_LOADER_DEBUG"] = "info";
        foreach (string argument in new[] { "picture", cloud, "-o", picture, "--quiet" })
            start.ArgumentList.Add(argument);
        if (isForGpu)
            start.ArgumentList.Add("--gpu");
        using Process process = Process.Start(start);
        string said = process.StandardError.ReadToEnd();
        process.WaitForExit();
        return said;
    }
}
