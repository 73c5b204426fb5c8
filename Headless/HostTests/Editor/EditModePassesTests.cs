namespace FastPoints.HostTests.Editor;

public sealed class EditModePassesTests
{
    [TearDown]
    public void End()
    {
        BuiltInPass.End();
        UrpPass.End();
        HdrpPass.End();
    }

    [Test]
    public void Begin_EditorLoaded_StartsEachPipelinesPassOnce()
    {
        var passes = new[] { typeof(BuiltInPass), typeof(UrpPass), typeof(HdrpPass) };
        var found = TypeCache.GetMethodsWithAttribute<Rendering.BeginsPassAttribute>();
        Assert.That(found.Count, Is.EqualTo(passes.Length));
        foreach (var begin in found)
            Assert.That(passes, Has.Member(begin.DeclaringType));
        BuiltInPass.End();
        Assert.That(Listening(), Is.Zero);
        EditModePasses.Begin();
        EditModePasses.Begin();
        Assert.That(Listening(), Is.EqualTo(1));
    }

    /// <summary>A Scene view's camera outlives its scripts: what was recorded for it would be drawn from memory that is
    /// gone.</summary>
    [Test]
    public void Reload_OfScripts_EndsEveryPipelinesPass()
    {
        System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(EditModePasses).TypeHandle);
        EditModePasses.Begin();
        Assert.That(Listening(), Is.EqualTo(1));
        AssemblyReloadEvents.Reload();
        Assert.That(Listening(), Is.Zero);
    }

    static int Listening() => (Camera.onPreCull?.GetInvocationList() ?? Array.Empty<Delegate>())
        .Count(d => d.Method.DeclaringType == typeof(BuiltInPass));
}
