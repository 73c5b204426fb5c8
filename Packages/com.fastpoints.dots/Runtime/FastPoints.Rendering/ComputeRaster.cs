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
        const int ClearThreads = 64;

        // Depth and colour; of progressive pictures also the number of a visible point.
        const int BytesPerPixel = 8, MaxBytesPerPixel = 12;

        static readonly string[] s_kernels =
            { ShaderNames.RasterDepthKernel, ShaderNames.RasterColorKernel, ShaderNames.ClearPixelsKernel };

        readonly ComputeShader m_shader;
        readonly int[] m_kernels;
        readonly int m_numberKernel;
        readonly bool m_isDepthOnly;

        // shader: RasterPoints.compute, or ProgressiveRaster.compute.
        public ComputeRaster(ComputeShader shader, bool isDepthOnly = false)
        {
            m_shader = shader;
            m_isDepthOnly = isDepthOnly;
            m_kernels = Array.ConvertAll(s_kernels, shader.FindKernel);
            m_numberKernel = shader.HasKernel(ShaderNames.RasterNumberKernel)
                ? shader.FindKernel(ShaderNames.RasterNumberKernel) : -1;
        }

        // Whether the device has what the kernels need. False for no shader.
        public static bool CanRun(ComputeShader shader) => VisiblePoints.CanRun(shader, s_kernels);

        public GraphicsBuffer Pixels { get; private set; } // Depth and colour of each pixel of the largest picture.

        // The device counts rows from the top, has buffers as large as the picture needs, and depth follows from the distance
        // along the view alone, which only oblique projections violate.
        public static bool CanDraw(in RenderView view)
        {
            var depth = (Vector3)view.ViewProjection.GetRow(2);
            long bytes = (long)view.WidthPx * view.HeightPx * (view.Style.IsProgressive ? MaxBytesPerPixel : BytesPerPixel);
            return SystemInfo.graphicsUVStartsAtTop &&
                bytes > 0 && bytes <= Math.Min(NodePool.MaxBankBytes, SystemInfo.maxGraphicsBufferSize) &&
                Vector3.Cross(depth, view.Forward).magnitude <= 1e-5f * Math.Max(depth.magnitude, float.Epsilon);
        }

        // For a distance d along the view: (x d + y) / (z d + w).
        public static Vector4 DepthToDevice(in RenderView view)
        {
            var z = view.ViewProjection.GetRow(2);
            var w = view.ViewProjection.GetRow(3);
            return new Vector4(Vector3.Dot(z, view.Forward), z.w, Vector3.Dot(w, view.Forward), w.w);
        }

        // chosen: which points a progressive picture draws, marked afterwards; null for all.
        public void Record(CommandBuffer commands, in RenderView view, DrawList list, ListBuffer listBuffer,
            GraphicsNodePool pool, VisiblePoints chosen)
        {
            EnsurePixels(view, chosen != null ? MaxBytesPerPixel : BytesPerPixel);
            commands.SetComputeVectorParam(m_shader, ShaderNames.ScreenPx, new Vector4(view.WidthPx, view.HeightPx, 0, 0));
            commands.SetComputeVectorParam(m_shader, ShaderNames.Forward, view.Forward);
            commands.SetComputeVectorParam(m_shader, ShaderNames.EyeOffset, view.EyeOffset);
            commands.SetComputeMatrixParam(m_shader, ShaderNames.ViewProjection, view.ViewProjection);
            commands.SetComputeIntParam(m_shader, ShaderNames.ClipBoxCount, list.ClipBoxes.Length);
            commands.SetComputeIntParam(m_shader, ShaderNames.IsLinear, 0);
            commands.SetComputeIntParam(m_shader, ShaderNames.IsOrthographic, view.IsOrthographic ? 1 : 0);
            if (list.IsLitByNormals)
                ShaderValues.SetLight(commands, m_shader, view.Light);
            int clear = m_kernels[2];
            commands.SetComputeBufferParam(m_shader, clear, ShaderNames.PixelsOut, Pixels);
            commands.DispatchCompute(m_shader, clear, (view.WidthPx + ClearThreads - 1) / ClearThreads, view.HeightPx, 1);
            for (int pass = 0; pass < (chosen != null ? 3 : m_isDepthOnly ? 1 : 2); pass++)
            {
                int kernel = pass < 2 ? m_kernels[pass] : m_numberKernel;
                commands.SetComputeBufferParam(m_shader, kernel, ShaderNames.PixelsOut, Pixels);
                listBuffer.Set(commands, m_shader, kernel);
                chosen?.Set(commands, kernel);
                for (int i = 0; i < list.Draws.Length; i++)
                {
                    commands.SetComputeBufferParam(m_shader, kernel, ShaderNames.Bank, pool.BufferOf(list.Draws[i].Bank));
                    if (chosen != null)
                        DispatchChosen(commands, kernel, i, chosen);
                    else
                        Dispatch(commands, m_shader, kernel, list.Draws[i]);
                }
            }
            chosen?.MarkPixels(commands, view, Pixels);
        }

        public void Dispose()
        {
            Pixels?.Dispose();
            Pixels = null;
        }

        void DispatchChosen(CommandBuffer commands, int kernel, int bank, VisiblePoints chosen)
        {
            commands.SetComputeIntParam(m_shader, ShaderNames.BankNumber, bank);
            commands.SetComputeIntParam(m_shader, ShaderNames.InstanceCount, int.MaxValue);
            commands.SetComputeIntParam(m_shader, ShaderNames.GroupsPerRow, VisiblePoints.MaxGroups);
            commands.DispatchCompute(m_shader, kernel, chosen.Arguments,
                (uint)(bank * VisiblePoints.NumbersPerDraw * sizeof(uint)));
        }

        // A group for each block of a bank, in rows.
        public static void Dispatch(CommandBuffer commands, ComputeShader shader, int kernel, in BankDraw draw)
        {
            int across = math.min(draw.InstanceCount, VisiblePoints.MaxGroups);
            commands.SetComputeIntParam(shader, ShaderNames.FirstInstance, draw.FirstInstance);
            commands.SetComputeIntParam(shader, ShaderNames.InstanceCount, draw.InstanceCount);
            commands.SetComputeIntParam(shader, ShaderNames.GroupsPerRow, across);
            commands.DispatchCompute(shader, kernel, across, (draw.InstanceCount + across - 1) / across, 1);
        }

        void EnsurePixels(in RenderView view, int bytesPerPixel)
        {
            int words = view.WidthPx * view.HeightPx * (bytesPerPixel / sizeof(uint));
            // One camera may be drawn at two sizes, in turn.
            if (Pixels != null && Pixels.count >= words)
                return;
            Pixels?.Dispose();
            Pixels = new GraphicsBuffer(GraphicsBuffer.Target.Raw, words, sizeof(uint));
        }
    }
}
