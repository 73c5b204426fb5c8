using System;
using FastPoints.Drawing;
using FastPoints.Store;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    // Which points of one eye's last picture were visible, as the GPU knows it: a picture of more points than a frame may draw
    // begins with these and tries a share of every block's others, until it is that of all points (Schuetz, Mandlburger,
    // Otepka, Wimmer, "Progressive Real-Time Rendering of One Billion Points Without Hierarchical Acceleration Structures",
    // 2020). What is carried over are points, not pixels, so nothing stays of what moved or is hidden.
    internal sealed class VisiblePoints : IDisposable
    {
        public const int MaxGroups = 65535; // Along one axis of a dispatch.
        public const int NumbersPerDraw = 5; // In the arguments, as draws with indices read them.

        // Of the buffer of chosen points: ProgressivePoints.hlsl.
        const int HeaderBytes = 16, BankBytes = 32;
        const int BlockBytes = 2 * PlaneShape.MaxPointsPerBlock / 8;
        const int Threads = 64;

        static readonly string[] s_kernels =
        {
            ShaderNames.CountVisibleKernel, ShaderNames.PlanFrameKernel, ShaderNames.ListVisibleKernel,
            ShaderNames.MarkPixelsKernel, ShaderNames.MarkTexelsKernel,
        };

        readonly ComputeShader m_shader;
        readonly int[] m_kernels;
        readonly GrowingBuffer m_chosen = new GrowingBuffer(GraphicsBuffer.Target.Raw, sizeof(uint));
        readonly GrowingBuffer m_arguments = new GrowingBuffer(
            GraphicsBuffer.Target.Structured | GraphicsBuffer.Target.IndirectArguments, sizeof(uint));
        GrowingBuffer m_last = new GrowingBuffer(GraphicsBuffer.Target.Raw, sizeof(uint));
        GrowingBuffer m_next = new GrowingBuffer(GraphicsBuffer.Target.Raw, sizeof(uint));
        NativeList<int> m_header = new NativeList<int>(Allocator.Persistent);
        int m_listNumber = -1; // Of the draw list, when points were marked last.
        int m_visibleAt;

        public VisiblePoints(ComputeShader shader)
        {
            m_shader = shader;
            m_kernels = Array.ConvertAll(s_kernels, shader.FindKernel);
        }

        // Whether the device has what the kernels need. False for no shader.
        public static bool CanRun(ComputeShader shader) => CanRun(shader, s_kernels);

        public static bool CanRun(ComputeShader shader, string[] kernels) => shader != null &&
            Array.TrueForAll(kernels, kernel => shader.HasKernel(kernel) && shader.IsSupported(shader.FindKernel(kernel)));

        public GraphicsBuffer Arguments => m_arguments.Buffer;

        // Fills the arguments of a draw, or of a dispatch if blocks have no vertices, for each of the list's.
        public void Choose(CommandBuffer commands, in RenderView view, DrawList list, ListBuffer lists, int verticesPerBlock)
        {
            int blocks = list.NodeOfInstance.Length;
            int room = view.WidthPx * view.HeightPx;
            WriteBanks(commands, list, room);
            m_arguments.Reserve((long)list.Draws.Length * NumbersPerDraw * sizeof(uint));
            m_last.Reserve(BlockBytes);
            m_next.Reserve((long)blocks * BlockBytes);
            // Blocks of a list before the last one are no longer known.
            bool carries = m_listNumber >= 0 && m_listNumber == list.ListNumber - 1;
            m_listNumber = list.ListNumber;
            int groups = (blocks + Threads - 1) / Threads, across = math.min(groups, MaxGroups);
            commands.SetComputeIntParam(m_shader, ShaderNames.BankCount, list.Draws.Length);
            commands.SetComputeIntParam(m_shader, ShaderNames.Capacity, room);
            commands.SetComputeIntParam(m_shader, ShaderNames.Carries, carries ? 1 : 0);
            commands.SetComputeIntParam(m_shader, ShaderNames.GroupsPerRow, across);
            commands.SetComputeIntParam(m_shader, ShaderNames.InstanceCount, blocks);
            commands.SetComputeIntParam(m_shader, ShaderNames.ListedPoints, (int)math.min(list.Points, int.MaxValue));
            commands.SetComputeIntParam(m_shader, ShaderNames.PointsPerFrame, view.Style.PointsPerFrame);
            commands.SetComputeIntParam(m_shader, ShaderNames.VerticesPerBlock, verticesPerBlock);
            commands.SetComputeIntParam(m_shader, ShaderNames.VisibleAt, m_visibleAt);
            for (int pass = 0; pass < 3; pass++)
            {
                int kernel = m_kernels[pass];
                lists.Set(commands, m_shader, kernel);
                commands.SetComputeBufferParam(m_shader, kernel, ShaderNames.ChosenOut, m_chosen.Buffer);
                commands.SetComputeBufferParam(m_shader, kernel, ShaderNames.ArgumentsOut, m_arguments.Buffer);
                commands.SetComputeBufferParam(m_shader, kernel, ShaderNames.Masks, m_last.Buffer);
                commands.SetComputeBufferParam(m_shader, kernel, ShaderNames.MasksOut, m_next.Buffer);
                if (s_kernels[pass] == ShaderNames.PlanFrameKernel)
                    commands.DispatchCompute(m_shader, kernel, 1, 1, 1);
                else
                    commands.DispatchCompute(m_shader, kernel, across, (groups + across - 1) / across, 1);
            }
        }

        // What kernels that draw points read.
        public void Set(CommandBuffer commands, int kernel) =>
            commands.SetComputeBufferParam(m_shader, kernel, ShaderNames.Chosen, m_chosen.Buffer);

        public void Set(MaterialPropertyBlock properties)
        {
            properties.SetBuffer(ShaderNames.Chosen, m_chosen.Buffer);
            properties.SetInteger(ShaderNames.VisibleAt, m_visibleAt);
        }

        public void MarkPixels(CommandBuffer commands, in RenderView view, GraphicsBuffer pixels)
        {
            commands.SetComputeBufferParam(m_shader, m_kernels[3], ShaderNames.PixelsOut, pixels);
            Mark(commands, view, m_kernels[3]);
        }

        public void MarkTexels(CommandBuffer commands, in RenderView view)
        {
            commands.SetComputeVectorParam(m_shader, ShaderNames.ScreenPx, new Vector4(view.WidthPx, view.HeightPx, 0, 0));
            commands.SetComputeTextureParam(m_shader, m_kernels[4], ShaderNames.LayerNumbers, ShaderNames.LayerNumbers);
            commands.SetComputeTextureParam(m_shader, m_kernels[4], ShaderNames.LayerColor, ShaderNames.LayerColor);
            Mark(commands, view, m_kernels[4]);
        }

        public void Dispose()
        {
            m_chosen.Dispose();
            m_arguments.Dispose();
            m_last.Dispose();
            m_next.Dispose();
            if (m_header.IsCreated)
                m_header.Dispose();
        }

        void Mark(CommandBuffer commands, in RenderView view, int kernel)
        {
            commands.SetComputeBufferParam(m_shader, kernel, ShaderNames.MasksOut, m_next.Buffer);
            commands.DispatchCompute(m_shader, kernel, (view.WidthPx + Threads - 1) / Threads, view.HeightPx, 1);
            (m_last, m_next) = (m_next, m_last);
        }

        void WriteBanks(CommandBuffer commands, DrawList list, int room)
        {
            m_visibleAt = HeaderBytes + list.Draws.Length * BankBytes;
            m_header.Clear();
            m_header.Resize(m_visibleAt / sizeof(int), NativeArrayOptions.ClearMemory);
            for (int i = 0; i < list.Draws.Length; i++)
            {
                int at = (HeaderBytes + i * BankBytes) / sizeof(int);
                m_header[at] = list.Draws[i].FirstInstance;
                m_header[at + 1] = list.Draws[i].InstanceCount;
            }
            // The first four numbers go on from picture to picture.
            int first = m_chosen.Reserve(m_visibleAt + (long)room * sizeof(uint)) ? 0 : HeaderBytes / sizeof(int);
            m_chosen.Write(commands, m_header.AsArray().GetSubArray(first, m_header.Length - first), first * sizeof(int));
        }
    }
}
