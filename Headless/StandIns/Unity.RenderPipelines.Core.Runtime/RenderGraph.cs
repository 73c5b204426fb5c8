using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering.RenderGraphModule
{
    [Flags]
    public enum AccessFlags
    {
        None = 0,
        Read = 1,
        Write = 2,
        ReadWrite = 3,
    }

    public struct TextureHandle
    {
        internal int Index;

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
        static readonly List<RTHandle> s_textures = new List<RTHandle>();
        readonly List<Action<UnsafeGraphContext>> m_passes = new List<Action<UnsafeGraphContext>>();

        public IUnsafeRenderGraphBuilder AddUnsafePass<PassData>(string passName, out PassData passData, string file = "",
            int line = 0) where PassData : class, new()
        {
            passData = new PassData();
            return new Builder(this, passData);
        }

        internal static RTHandle TextureOf(TextureHandle handle) => s_textures[handle.Index];

        internal static TextureHandle Import(RTHandle texture)
        {
            s_textures.Add(texture);
            return new TextureHandle { Index = s_textures.Count - 1 };
        }

        internal void Execute(CommandBuffer commands)
        {
            var context = new UnsafeGraphContext { cmd = new UnsafeCommandBuffer(commands) };
            foreach (var pass in m_passes)
                pass(context);
            m_passes.Clear();
        }

        sealed class Builder : IUnsafeRenderGraphBuilder
        {
            readonly RenderGraph m_graph;
            readonly object m_data;
            Action<UnsafeGraphContext> m_pass;
            bool m_isCulled = true;

            public Builder(RenderGraph graph, object data)
            {
                m_graph = graph;
                m_data = data;
            }

            public void UseTexture(in TextureHandle input, AccessFlags flags = AccessFlags.Read)
            {
            }

            public void AllowPassCulling(bool value) => m_isCulled = value;

            public void SetRenderFunc<PassData>(BaseRenderFunc<PassData, UnsafeGraphContext> renderFunc) where PassData : class, new() =>
                m_pass = context => renderFunc((PassData)m_data, context);

            public void Dispose()
            {
                // Nothing reads what an unsafe pass writes, as far as the graph knows: it goes unless it is told to stay.
                if (!m_isCulled)
                    m_graph.m_passes.Add(m_pass);
            }
        }
    }
}
