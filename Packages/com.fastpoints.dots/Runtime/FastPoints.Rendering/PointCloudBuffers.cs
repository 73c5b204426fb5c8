using System;
using FastPoints.Drawing;
using FastPoints.Streaming;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    /// <summary>The points of one cloud for effects: those that the cameras' pictures have, unpacked on the graphics card into
    /// one buffer, whose content changes in <see cref="Update"/> alone. Shaders include
    /// <c>Packages/com.fastpoints.dots/Shaders/PointCloudBuffers.hlsl</c> and call <c>FastPoints_Load(i, position, color)</c>.
    /// Nothing is allocated before the first update. Main thread, no garbage.</summary>
    public sealed class PointCloudBuffers : IDisposable
    {
        /// <summary>Of a point in <see cref="Points"/>: three floats, from <see cref="OriginWorld"/> along the world's axes, and
        /// a colour in sRGB, red in the lowest byte, whose alpha is 0 where a clip box or a hidden class takes the point
        /// away.</summary>
        public const int BytesPerPoint = 16;

        /// <summary>Every graphics card supports buffers of this size.</summary>
        public const int MaxPointsLimit = NodePool.MaxBankBytes / BytesPerPoint;

        static readonly string[] s_kernels = { ShaderNames.GatherPointsKernel };
        static readonly CloudLook s_noLook = new CloudLook { Plane = -1 };

        readonly int m_maxPoints;
        ComputeShader m_gather;
        int m_kernel; // -1 where the device cannot run it.
        SizeTree m_sizes;
        DrawList m_list;
        ListBuffer m_listBuffer;
        CommandBuffer m_commands;
        int m_cloud;

        /// <param name="maxPoints">Of more points an even share is kept; 1 to <see cref="MaxPointsLimit"/>.</param>
        public PointCloudBuffers(int maxPoints)
        {
            if (maxPoints < 1 || maxPoints > MaxPointsLimit)
                throw new ArgumentOutOfRangeException(nameof(maxPoints), maxPoints, "wanted 1 to " + MaxPointsLimit);
            m_maxPoints = maxPoints;
        }

        /// <summary>Structured, room for all points that may be kept; the same from the first update on, null before.</summary>
        public GraphicsBuffer Points { get; private set; }

        /// <summary>Points in the buffer.</summary>
        public int Count { get; private set; }

        /// <summary>How many of the pictures' points are in the buffer, from 0 to 1.</summary>
        public double Fraction { get; private set; }

        /// <summary>What positions in the buffer count from.</summary>
        public double3 OriginWorld { get; private set; }

        /// <summary>Gathers the points that the last frame chose for any camera, as the cloud stands now.</summary>
        /// <param name="cloud">Its number: <c>PointCloud.Number</c>, or that of a hit.</param>
        /// <param name="originWorld">Near the effect: positions are as exact as floats are at this distance.</param>
        /// <returns>False if the cloud is not shown, or the device cannot: the buffer stays as it is.</returns>
        public bool Update(int cloud, double3 originWorld)
        {
            var scene = PointScene.Current;
            if (scene == null || !scene.TryGetLook(cloud, out var look) || !HasKernel())
                return false;
            Gather(scene.Stream, cloud, look, originWorld);
            return true;
        }

        /// <summary>Lets a kernel call FastPoints_Load, until the next update.</summary>
        public void Bind(ComputeShader shader, int kernel)
        {
            shader.SetBuffer(kernel, ShaderNames.EffectPoints, Gathered);
            shader.SetInt(ShaderNames.EffectPointCount, Count);
            shader.SetVector(ShaderNames.EffectOrigin, OriginAndIsLinear);
        }

        /// <summary>The same for what draws with these properties.</summary>
        public void Bind(MaterialPropertyBlock properties)
        {
            properties.SetBuffer(ShaderNames.EffectPoints, Gathered);
            properties.SetInteger(ShaderNames.EffectPointCount, Count);
            properties.SetVector(ShaderNames.EffectOrigin, OriginAndIsLinear);
        }

        /// <summary>Frees the buffer.</summary>
        public void Dispose()
        {
            Points?.Dispose();
            m_list?.Dispose();
            m_listBuffer?.Dispose();
            m_sizes?.Dispose();
            m_commands?.Dispose();
            (Points, m_list, m_listBuffer, m_sizes, m_commands, Count) = (null, null, null, null, null, 0);
        }

        bool HasKernel()
        {
            if (m_gather != null)
                return m_kernel >= 0;
            m_gather = PointCloudResources.Load().Gather;
            m_kernel = VisiblePoints.CanRun(m_gather, s_kernels) ? m_gather.FindKernel(ShaderNames.GatherPointsKernel) : -1;
            return m_kernel >= 0;
        }

        GraphicsBuffer Gathered => Points ?? throw new InvalidOperationException("no points are gathered yet: see Update");

        Vector4 OriginAndIsLinear => new Vector4((float)OriginWorld.x, (float)OriginWorld.y, (float)OriginWorld.z,
            QualitySettings.activeColorSpace == ColorSpace.Linear ? 1 : 0);

        void Gather(StreamContext stream, int cloud, in CloudLook look, double3 originWorld)
        {
            Points ??= new GraphicsBuffer(GraphicsBuffer.Target.Structured, m_maxPoints, BytesPerPoint);
            m_sizes ??= new SizeTree();
            m_list ??= new DrawList(m_sizes);
            m_listBuffer ??= new ListBuffer();
            m_commands ??= new CommandBuffer { name = "Gather points" };
            m_list.SetLook(m_cloud, s_noLook);
            m_list.SetLook(m_cloud = cloud, look);
            var view = StreamView.Everything(1);
            view.EyeWorld = OriginWorld = originWorld;
            m_list.Build(stream, view);
            // In 2^-32; the shader counts alike.
            ulong keptShare = m_list.Points <= m_maxPoints ? 0 : ((ulong)m_maxPoints << 32) / (ulong)m_list.Points;
            Count = (int)(keptShare == 0 ? (ulong)m_list.Points : (ulong)m_list.Points * keptShare >> 32);
            Fraction = m_list.Points == 0 ? 1 : (double)Count / m_list.Points;
            m_commands.Clear();
            Record((int)(uint)keptShare, (GraphicsNodePool)stream.Pool);
            Graphics.ExecuteCommandBuffer(m_commands);
        }

        void Record(int keptShare, GraphicsNodePool pool)
        {
            m_listBuffer.Write(m_commands, m_list);
            m_listBuffer.Set(m_commands, m_gather, m_kernel);
            m_commands.SetComputeBufferParam(m_gather, m_kernel, ShaderNames.EffectPointsOut, Points);
            m_commands.SetComputeIntParam(m_gather, ShaderNames.ClipBoxCount, m_list.ClipBoxes.Length);
            m_commands.SetComputeIntParam(m_gather, ShaderNames.KeptShare, keptShare);
            for (int i = 0; i < m_list.Draws.Length; i++)
            {
                var draw = m_list.Draws[i];
                m_commands.SetComputeBufferParam(m_gather, m_kernel, ShaderNames.Bank, pool.BufferOf(draw.Bank));
                ComputeRaster.Dispatch(m_commands, m_gather, m_kernel, draw);
            }
        }
    }
}
