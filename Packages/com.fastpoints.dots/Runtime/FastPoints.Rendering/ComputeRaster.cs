using System;
using FastPoints.Drawing;
using FastPoints.Streaming;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    // Draws points of one pixel with RasterPoints.compute into a buffer of 8 bytes a pixel, for one camera: in place of point
    // primitives wherever CanDraw allows it.
    sealed class ComputeRaster : IDisposable
    {
        const int BytesPerPixel = 8, ClearThreads = 64;
        const int MaxGroups = 65535; // Along one axis of a dispatch.

        static readonly string[] s_kernels =
            { ShaderNames.RasterDepthKernel, ShaderNames.RasterColorKernel, ShaderNames.ClearPixelsKernel };

        readonly ComputeShader m_shader;
        readonly int[] m_kernels;

        public ComputeRaster(ComputeShader shader)
        {
            m_shader = shader;
            m_kernels = Array.ConvertAll(s_kernels, shader.FindKernel);
        }

        // Whether the device has what the kernels need. False for no shader.
        public static bool CanRun(ComputeShader shader) => shader != null &&
            Array.TrueForAll(s_kernels, kernel => shader.HasKernel(kernel) && shader.IsSupported(shader.FindKernel(kernel)));

        // Depth and colour of each pixel of the largest picture.
        public GraphicsBuffer Pixels { get; private set; }

        // The device counts rows from the top, has buffers as large as the picture needs, and depth follows from the distance
        // along the view alone, which only oblique projections violate.
        public static bool CanDraw(in RenderView view)
        {
            var depth = (Vector3)view.ViewProjection.GetRow(2);
            long bytes = (long)view.WidthPx * view.HeightPx * BytesPerPixel;
            return SystemInfo.graphicsUVStartsAtTop &&
                bytes > 0 && bytes <= Math.Min(NodePool.LargestBankBytes, SystemInfo.maxGraphicsBufferSize) &&
                Vector3.Cross(depth, view.Forward).magnitude <= 1e-5f * Math.Max(depth.magnitude, float.Epsilon);
        }

        // For a distance d along the view: (x d + y) / (z d + w).
        public static Vector4 DepthToDevice(in RenderView view)
        {
            var z = view.ViewProjection.GetRow(2);
            var w = view.ViewProjection.GetRow(3);
            return new Vector4(Vector3.Dot(z, view.Forward), z.w, Vector3.Dot(w, view.Forward), w.w);
        }

        public void Record(CommandBuffer commands, in RenderView view, DrawList list, ListBuffer lists, GraphicsNodePool pool)
        {
            EnsurePixels(view);
            commands.SetComputeVectorParam(m_shader, ShaderNames.ScreenPx, new Vector4(view.WidthPx, view.HeightPx, 0, 0));
            commands.SetComputeVectorParam(m_shader, ShaderNames.Forward, view.Forward);
            commands.SetComputeVectorParam(m_shader, ShaderNames.EyeOffset, view.EyeOffset);
            commands.SetComputeMatrixParam(m_shader, ShaderNames.ViewProjection, view.ViewProjection);
            commands.SetComputeIntParam(m_shader, ShaderNames.ClipBoxCount, list.ClipBoxes.Length);
            commands.SetComputeIntParam(m_shader, ShaderNames.IsLinear, 0);
            int clear = m_kernels[2];
            commands.SetComputeBufferParam(m_shader, clear, ShaderNames.PixelsOut, Pixels);
            commands.DispatchCompute(m_shader, clear, (view.WidthPx + ClearThreads - 1) / ClearThreads, view.HeightPx, 1);
            for (int pass = 0; pass < 2; pass++)
            {
                int kernel = m_kernels[pass];
                commands.SetComputeBufferParam(m_shader, kernel, ShaderNames.PixelsOut, Pixels);
                lists.Set(commands, m_shader, kernel);
                for (int i = 0; i < list.Draws.Length; i++)
                    Dispatch(commands, kernel, list.Draws[i], pool);
            }
        }

        public void Dispose()
        {
            Pixels?.Dispose();
            Pixels = null;
        }

        void Dispatch(CommandBuffer commands, int kernel, in BankDraw draw, GraphicsNodePool pool)
        {
            int across = math.min(draw.InstanceCount, MaxGroups);
            commands.SetComputeBufferParam(m_shader, kernel, ShaderNames.Bank, pool.BufferOf(draw.Bank));
            commands.SetComputeIntParam(m_shader, ShaderNames.FirstInstance, draw.FirstInstance);
            commands.SetComputeIntParam(m_shader, ShaderNames.InstanceCount, draw.InstanceCount);
            commands.SetComputeIntParam(m_shader, ShaderNames.GroupsPerRow, across);
            commands.DispatchCompute(m_shader, kernel, across, (draw.InstanceCount + across - 1) / across, 1);
        }

        void EnsurePixels(in RenderView view)
        {
            int words = view.WidthPx * view.HeightPx * (BytesPerPixel / sizeof(uint));
            // One camera may be drawn at two sizes, in turn.
            if (Pixels != null && Pixels.count >= words)
                return;
            Pixels?.Dispose();
            Pixels = new GraphicsBuffer(GraphicsBuffer.Target.Raw, words, sizeof(uint));
        }
    }
}
