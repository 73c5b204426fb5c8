using UnityEngine.Rendering.RenderGraphModule;

namespace UnityOutside.Tests.StandIns.Graphics;

public sealed class RenderGraphTests
{
    private sealed class Data
    {
        public int Value;
    }

    private readonly RenderGraph m_graph = new RenderGraph();

    private static TextureHandle Texture() => RenderGraph.Import(new RTHandle());

    private int Run(System.Action<Data> function, bool isKept = true, params TextureHandle[] used)
    {
        using (var builder = m_graph.AddUnsafePass<Data>("pass", out _))
        {
            foreach (TextureHandle texture in used)
                builder.UseTexture(texture, AccessFlags.ReadWrite);
            builder.AllowPassCulling(!isKept);
            builder.SetRenderFunc<Data>((data, _) => function(data));
        }
        int passes = m_graph.PassCount;
        using var commands = new CommandBuffer();
        m_graph.Execute(commands);
        return passes;
    }

    [Test]
    public void Pass_CullingAllowed_IsCulled()
    {
        bool ran = false;
        Assert.That(Run(_ => ran = true, isKept: false), Is.Zero);
        Assert.That(ran, Is.False);
        Assert.That(Run(_ => ran = true), Is.EqualTo(1));
        Assert.That(ran, Is.True);
    }

    [Test]
    public void Texture_OutsideOfAPassThatUsesIt_Throws()
    {
        TextureHandle texture = Texture(), other = Texture();
        Assert.That(() => (RTHandle)texture, Throws.InvalidOperationException.With.Message.Contains("while a pass is executed"));
        Run(_ => Assert.That((RTHandle)texture, Is.Not.Null), true, texture);
        Assert.That(() => Run(_ => { RTHandle __ = other; }, true, texture),
            Throws.InvalidOperationException.With.Message.Contains("did not say"));
    }

    [Test]
    public void Builder_Misused_Throws()
    {
        using var builder = m_graph.AddUnsafePass<Data>("pass", out _);
        Assert.That(() => builder.UseTexture(default), Throws.ArgumentException);
        Assert.That(() => builder.Dispose(), Throws.InvalidOperationException.With.Message.Contains("render function"));
        builder.SetRenderFunc<Data>((_, __) => { });
    }

    [Test]
    public void PassData_Reused_HasTheLastPassesValues()
    {
        Run(data => data.Value = 7);
        Run(data => Assert.That(data.Value, Is.EqualTo(7)));
    }
}
