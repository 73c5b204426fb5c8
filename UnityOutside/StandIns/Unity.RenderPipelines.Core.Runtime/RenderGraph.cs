using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering.RenderGraphModule;

[Flags]
public enum AccessFlags { None = 0, Read = 1, Write = 2, ReadWrite = 3 }

/// <summary>Stands for a texture while the function of a pass that uses it runs, and at no other time.</summary>
public struct TextureHandle
{
    internal int Index; // From 1 on: a handle that nobody gave stands for nothing.

    public readonly bool IsValid() => Index > 0;

    public static implicit operator RenderTargetIdentifier(TextureHandle texture) => RenderGraph.TextureOf(texture);
    public static implicit operator RTHandle(TextureHandle texture) => RenderGraph.TextureOf(texture);
}

public class UnsafeGraphContext
{
    public UnsafeCommandBuffer cmd;
}

public delegate void BaseRenderFunc<PassData, ContextType>(PassData data, ContextType renderGraphContext)
    where PassData : class, new();

public interface IBaseRenderGraphBuilder : IDisposable
{
    void UseTexture(in TextureHandle input, AccessFlags flags = AccessFlags.Read);
    void AllowPassCulling(bool value);
}

public interface IUnsafeRenderGraphBuilder : IBaseRenderGraphBuilder
{
    void SetRenderFunc<PassData>(BaseRenderFunc<PassData, UnsafeGraphContext> renderFunc) where PassData : class, new();
}

public interface IRenderGraphRecorder
{
    void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData);
}

/// <summary>Runs its passes in the order in which they were added; a pass may touch only what it said that it uses.</summary>
public class RenderGraph
{
    static readonly List<RTHandle> s_textures = new List<RTHandle> { null };
    static readonly Dictionary<Type, object> s_data = new Dictionary<Type, object>();
    static List<int> s_used; // What the pass that runs has said that it uses; null while none runs.
    readonly List<(Action<UnsafeGraphContext> Run, List<int> Used)> m_passes =
        new List<(Action<UnsafeGraphContext>, List<int>)>();

    public IUnsafeRenderGraphBuilder AddUnsafePass<PassData>(string passName, out PassData passData, string file = "",
        int line = 0) where PassData : class, new()
    {
        if (!s_data.TryGetValue(typeof(PassData), out var data))
            s_data.Add(typeof(PassData), data = new PassData());
        passData = (PassData)data;
        return new Builder(this, passName, passData);
    }

    internal static RTHandle TextureOf(TextureHandle handle)
    {
        if (s_used == null)
            throw new InvalidOperationException("A TextureHandle stands for a texture only while a pass is executed");
        if (!s_used.Contains(handle.Index))
            throw new InvalidOperationException("The pass did not say that it uses this texture");
        return s_textures[handle.Index];
    }

    internal static TextureHandle Import(RTHandle texture)
    {
        s_textures.Add(texture);
        return new TextureHandle { Index = s_textures.Count - 1 };
    }

    internal int PassCount => m_passes.Count;

    internal void Execute(CommandBuffer commands)
    {
        var context = new UnsafeGraphContext { cmd = new UnsafeCommandBuffer(commands) };
        foreach (var (run, used) in m_passes)
        {
            s_used = used;
            try
            {
                run(context);
            }
            finally
            {
                s_used = null;
            }
        }
        m_passes.Clear();
    }

    sealed class Builder(RenderGraph graph, string name, object data) : IUnsafeRenderGraphBuilder
    {
        readonly RenderGraph m_graph = graph;
        readonly string m_name = name;
        readonly object m_data = data;
        readonly List<int> m_used = new List<int>();
        Action<UnsafeGraphContext> m_pass;
        bool m_isCulled = true;

        public void UseTexture(in TextureHandle input, AccessFlags flags = AccessFlags.Read)
        {
            if (input.Index == 0)
                throw new ArgumentException($"Pass {m_name}: trying to use an invalid resource");
            m_used.Add(input.Index);
        }

        public void AllowPassCulling(bool value) => m_isCulled = value;

        public void SetRenderFunc<PassData>(BaseRenderFunc<PassData, UnsafeGraphContext> renderFunc)
            where PassData : class, new() => m_pass = context => renderFunc((PassData)m_data, context);

        public void Dispose()
        {
            if (m_pass == null)
                throw new InvalidOperationException($"Pass {m_name} was not provided with a render function");
            // Nothing reads what an unsafe pass writes, as far as the graph knows: it goes unless it is told to stay.
            if (!m_isCulled)
                m_graph.m_passes.Add((m_pass, m_used));
        }
    }
}
