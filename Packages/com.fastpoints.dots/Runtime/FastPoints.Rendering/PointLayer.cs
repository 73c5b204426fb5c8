using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    // Holds points alone, for styles that look at a point's neighbours: they are then composed into the camera's picture with
    // their depth. It therefore does not read the picture's own targets.
    sealed class PointLayer
    {
        // Floats where the device can blend them: exact for 2,000 points a pixel. With halves, colours are exact to a few
        // 255ths for some 20 points.
        static GraphicsFormat Sums =>
            SystemInfo.IsFormatSupported(GraphicsFormat.R32G32B32A32_SFloat, GraphicsFormatUsage.Blend)
                ? GraphicsFormat.R32G32B32A32_SFloat : GraphicsFormat.R16G16B16A16_SFloat;

        readonly RenderTargetIdentifier[] m_targets = { ShaderNames.LayerColor, ShaderNames.LayerDepth };
        readonly RenderTargetIdentifier[] m_numberedTargets =
            { ShaderNames.LayerColor, ShaderNames.LayerDepth, ShaderNames.LayerNumbers };

        public MaterialPropertyBlock Properties { get; } = new MaterialPropertyBlock(); // Of composing.

        public void Begin(CommandBuffer commands, in RenderView view)
        {
            commands.GetTemporaryRT(ShaderNames.LayerColor, Describe(view, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.None));
            commands.GetTemporaryRT(ShaderNames.LayerDepth, Describe(view, GraphicsFormat.R32G32_SFloat, GraphicsFormat.None));
            commands.GetTemporaryRT(ShaderNames.LayerDevice, Describe(view, GraphicsFormat.None, GraphicsFormat.D32_SFloat));
            if (view.Style.IsProgressive)
                commands.GetTemporaryRT(ShaderNames.LayerNumbers, Describe(view, GraphicsFormat.R32_UInt, GraphicsFormat.None));
            commands.SetRenderTarget(view.Style.IsProgressive ? m_numberedTargets : m_targets, ShaderNames.LayerDevice);
            commands.ClearRenderTarget(true, true, UnityEngine.Color.clear);
        }

        // Unbinds the numbers, which MarkTexels reads.
        public void EndNumbers(CommandBuffer commands, in RenderView view, VisiblePoints chosen)
        {
            commands.SetRenderTarget(ShaderNames.LayerDepth, ShaderNames.LayerDevice);
            chosen.MarkTexels(commands, view);
            commands.ReleaseTemporaryRT(ShaderNames.LayerNumbers);
        }

        // The second drawing of the same points, which adds them up.
        public void BeginBlending(CommandBuffer commands, in RenderView view)
        {
            commands.GetTemporaryRT(ShaderNames.LayerSums, Describe(view, Sums, GraphicsFormat.None));
            commands.SetRenderTarget(ShaderNames.LayerSums, ShaderNames.LayerDevice);
            commands.ClearRenderTarget(false, true, UnityEngine.Color.clear);
        }

        public void End(CommandBuffer commands, in RenderView view, PointMaterials materials)
        {
            var from = view.Style.IsBlended ? ComposedFrom.Sums : ComposedFrom.Layer;
            Compose(commands, view, materials.ForCompose(from, view.Style));
            if (view.Style.IsBlended)
                commands.ReleaseTemporaryRT(ShaderNames.LayerSums);
            commands.ReleaseTemporaryRT(ShaderNames.LayerColor);
            commands.ReleaseTemporaryRT(ShaderNames.LayerDepth);
            commands.ReleaseTemporaryRT(ShaderNames.LayerDevice);
        }

        public void Compose(CommandBuffer commands, in RenderView view, PointMaterials materials, ComputeRaster raster)
        {
            Properties.SetBuffer(ShaderNames.Pixels, raster.Pixels);
            Properties.SetVector(ShaderNames.DepthToDevice, ComputeRaster.DepthToDevice(view));
            Compose(commands, view, materials.ForCompose(ComposedFrom.Pixels, view.Style));
        }

        void Compose(CommandBuffer commands, in RenderView view, Material compose)
        {
            Properties.SetVector(ShaderNames.Flip, view.Flip);
            Properties.SetVector(ShaderNames.ScreenPx, new Vector4(view.WidthPx, view.HeightPx, 0, 0));
            Properties.SetVector(ShaderNames.ScalePx, new Vector4(view.ScalePx, view.IsOrthographic ? 1 : 0, 0, 0));
            Properties.SetFloat(ShaderNames.EdlStrength, view.Style.EdlStrength);
            Properties.SetInteger(ShaderNames.FillsHoles, view.Style.FillsHoles ? 1 : 0);
            Properties.SetInteger(ShaderNames.IsLinear, view.IsLinear ? 1 : 0);
            if (view.Style.IsLit)
            {
                ShaderValues.SetPixelPositions(Properties, view.PixelPositions);
                ShaderValues.SetLight(Properties, view.Light);
            }
            commands.DrawProcedural(Matrix4x4.identity, compose, 0, MeshTopology.Triangles, 3, 1, Properties);
        }

        public static void SetCameraTarget(CommandBuffer commands, in RenderView view)
        {
            // -1 stands for all slices.
            commands.SetRenderTarget(view.Color, view.Depth, 0, CubemapFace.Unknown, (int)view.Eye - 1);
            if (view.IsSubViewport)
                commands.SetViewport(new Rect(0, 0, view.WidthPx, view.HeightPx));
        }

        static RenderTextureDescriptor Describe(in RenderView view, GraphicsFormat color, GraphicsFormat depth) =>
            new RenderTextureDescriptor(view.WidthPx, view.HeightPx, color, depth);
    }
}
