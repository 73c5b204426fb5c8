using FastPoints.Drawing;
using Unity.Mathematics;
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

        readonly MaterialPropertyBlock m_properties = new MaterialPropertyBlock();
        readonly RenderTargetIdentifier[] m_targets = { ShaderNames.LayerColor, ShaderNames.LayerDepth };
        readonly RenderTargetIdentifier[] m_numberedTargets =
            { ShaderNames.LayerColor, ShaderNames.LayerDepth, ShaderNames.LayerNumbers };

        public PointShadows Shadows { get; set; } // Of styles that are shadowed.

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

        // Draws the layer into the camera's picture and releases it.
        public void End(CommandBuffer commands, in RenderView view, PointMaterials materials)
        {
            var from = view.Style.IsBlended ? ComposedFrom.Sums : ComposedFrom.Layer;
            Compose(commands, view, materials.Compose(from, view.Style));
            if (view.Style.IsBlended)
                commands.ReleaseTemporaryRT(ShaderNames.LayerSums);
            commands.ReleaseTemporaryRT(ShaderNames.LayerColor);
            commands.ReleaseTemporaryRT(ShaderNames.LayerDepth);
            commands.ReleaseTemporaryRT(ShaderNames.LayerDevice);
        }

        public void Compose(CommandBuffer commands, in RenderView view, PointMaterials materials, ComputeRaster raster)
        {
            m_properties.SetBuffer(ShaderNames.Pixels, raster.Pixels);
            m_properties.SetVector(ShaderNames.DepthToDevice, ComputeRaster.DepthToDevice(view));
            Compose(commands, view, materials.Compose(ComposedFrom.Pixels, view.Style));
        }

        void Compose(CommandBuffer commands, in RenderView view, Material compose)
        {
            m_properties.SetVector(ShaderNames.Flip, view.Flip);
            m_properties.SetVector(ShaderNames.ScreenPx, new Vector4(view.WidthPx, view.HeightPx, 0, 0));
            m_properties.SetVector(ShaderNames.ScalePx, new Vector4(view.ScalePx, view.IsOrthographic ? 1 : 0, 0, 0));
            m_properties.SetFloat(ShaderNames.EdlStrength, view.Style.EdlStrength);
            m_properties.SetInteger(ShaderNames.FillsHoles, view.Style.FillsHoles ? 1 : 0);
            m_properties.SetInteger(ShaderNames.IsLinear, view.IsLinear ? 1 : 0);
            if (view.Style.IsLit)
            {
                var places = view.Places;
                m_properties.SetMatrix(ShaderNames.Places, RowsOf(VectorOf(places.First),
                    VectorOf(places.StepX), VectorOf(places.StepY), VectorOf(places.Forward)));
                SetLight(m_properties, view.Light);
            }
            if (view.Style.IsShadowed)
                Shadows.Set(m_properties, view.EyeOffset);
            commands.DrawProcedural(Matrix4x4.identity, compose, 0, MeshTopology.Triangles, 3, 1, m_properties);
        }

        public static void SetLight(MaterialPropertyBlock properties, in PointLight light)
        {
            properties.SetMatrix(ShaderNames.Ambient, AmbientOf(light));
            properties.SetVector(ShaderNames.LightDirection, VectorOf(light.Direction));
            properties.SetVector(ShaderNames.LightColor, VectorOf(light.Color));
            properties.SetInteger(ShaderNames.AdditionalCount, light.AdditionalCount);
            if (light.AdditionalCount == 0)
                return;
            properties.SetMatrix(ShaderNames.AdditionalPlaces, PlacesOf(light));
            properties.SetMatrix(ShaderNames.AdditionalColors, ColorsOf(light));
            properties.SetMatrix(ShaderNames.AdditionalAxes, AxesOf(light));
        }

        public static void SetLight(CommandBuffer commands, ComputeShader shader, in PointLight light)
        {
            commands.SetComputeMatrixParam(shader, ShaderNames.Ambient, AmbientOf(light));
            commands.SetComputeVectorParam(shader, ShaderNames.LightDirection, VectorOf(light.Direction));
            commands.SetComputeVectorParam(shader, ShaderNames.LightColor, VectorOf(light.Color));
            commands.SetComputeIntParam(shader, ShaderNames.AdditionalCount, light.AdditionalCount);
            commands.SetComputeMatrixParam(shader, ShaderNames.AdditionalPlaces, PlacesOf(light));
            commands.SetComputeMatrixParam(shader, ShaderNames.AdditionalColors, ColorsOf(light));
            commands.SetComputeMatrixParam(shader, ShaderNames.AdditionalAxes, AxesOf(light));
        }

        static Matrix4x4 AmbientOf(in PointLight light) => RowsOf(VectorOf(light.AmbientX), VectorOf(light.AmbientY),
            VectorOf(light.AmbientZ), VectorOf(light.AmbientAll));

        static Matrix4x4 PlacesOf(in PointLight light) => RowsOf(VectorOf(light.Light0.Place, light.Light0.ConeOffset),
            VectorOf(light.Light1.Place, light.Light1.ConeOffset), VectorOf(light.Light2.Place, light.Light2.ConeOffset),
            VectorOf(light.Light3.Place, light.Light3.ConeOffset));

        static Matrix4x4 ColorsOf(in PointLight light) => RowsOf(VectorOf(light.Light0.Color, light.Light0.OneOverRangeSq),
            VectorOf(light.Light1.Color, light.Light1.OneOverRangeSq), VectorOf(light.Light2.Color, light.Light2.OneOverRangeSq),
            VectorOf(light.Light3.Color, light.Light3.OneOverRangeSq));

        static Matrix4x4 AxesOf(in PointLight light) => RowsOf(VectorOf(light.Light0.Axis, light.Light0.ConeScale),
            VectorOf(light.Light1.Axis, light.Light1.ConeScale), VectorOf(light.Light2.Axis, light.Light2.ConeScale),
            VectorOf(light.Light3.Axis, light.Light3.ConeScale));

        public static Vector4 VectorOf(float3 value, float w = 0) => new Vector4(value.x, value.y, value.z, w);

        public static Matrix4x4 RowsOf(Vector4 row0, Vector4 row1, Vector4 row2, Vector4 row3)
        {
            var rows = new Matrix4x4();
            rows.SetRow(0, row0);
            rows.SetRow(1, row1);
            rows.SetRow(2, row2);
            rows.SetRow(3, row3);
            return rows;
        }

        public static void SetTarget(CommandBuffer commands, in RenderView view)
        {
            // -1 stands for all slices.
            commands.SetRenderTarget(view.Color, view.Depth, 0, CubemapFace.Unknown, (int)view.Eye - 1);
            if (view.IsPart)
                commands.SetViewport(new Rect(0, 0, view.WidthPx, view.HeightPx));
        }

        static RenderTextureDescriptor Describe(in RenderView view, GraphicsFormat color, GraphicsFormat depth) =>
            new RenderTextureDescriptor(view.WidthPx, view.HeightPx, color, depth);
    }
}
