using System;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    /// <summary>Draws the resident nodes for one camera: Prepare after the stream's frame, then Record into any pipeline's
    /// command buffer. One indirect draw for each bank of the pool; an instance is a block. Main thread, no garbage.</summary>
    public sealed class PointRenderer : IDisposable
    {
        const int BlendingPass = 1, ProgressivePass = 2; // Of Points.shader.

        readonly GraphicsNodePool m_pool;
        readonly PointMaterials m_materials;
        readonly MaterialPropertyBlock m_properties = new MaterialPropertyBlock();
        readonly ListBuffer m_lists = new ListBuffer();
        readonly GrowingBuffer m_arguments = new GrowingBuffer(GraphicsBuffer.Target.IndirectArguments,
            GraphicsBuffer.IndirectDrawIndexedArgs.size);
        readonly PointLayer m_layer = new PointLayer();
        readonly ComputeRaster m_raster;
        readonly ProgressivePictures m_progressive;
        MainLightShadows m_shadows;
        NativeList<GraphicsBuffer.IndirectDrawIndexedArgs> m_drawArguments;

        /// <summary>Cameras' renderers may share all of these, which others dispose.</summary>
        public PointRenderer(PointMaterials materials, GraphicsNodePool pool, SizeTree sizes)
        {
            List = new DrawList(sizes);
            m_pool = pool;
            m_materials = materials;
            m_raster = ComputeRaster.CanRun(materials.Raster) ? new ComputeRaster(materials.Raster) : null;
            m_progressive = new ProgressivePictures(materials.Progressive);
            m_drawArguments = new NativeList<GraphicsBuffer.IndirectDrawIndexedArgs>(Allocator.Persistent);
        }

        /// <summary>What the last <see cref="Prepare"/> listed to draw, and how clouds look.</summary>
        public DrawList List { get; }

        /// <summary>Lists what a camera in the world of the stream's placements sees of the last frame.</summary>
        public void Prepare(StreamContext stream, in StreamView view, in PointStyle style)
        {
            BeginPicture(stream, view, style, null);
            List.Build(stream, view, style.IsAdaptive);
        }

        /// <summary>Lists what either eye sees, relative to the left one.</summary>
        public void Prepare(StreamContext stream, in StreamView left, in StreamView right, in PointStyle style)
        {
            BeginPicture(stream, left, style, right);
            List.Build(stream, left, style.IsAdaptive, right);
        }

        // What the light of the last picture needs to have loaded; null without shadows.
        internal StreamView? ShadowView => m_shadows?.View;

        void BeginPicture(StreamContext stream, in StreamView view, in PointStyle style, StreamView? rightEye)
        {
            m_pool.BeginPicture();
            List.IsProgressive = m_progressive.Begin(style);
            // Shadows are of what a layer has.
            List.IgnoresNormals = style.Shadows && m_raster != null;
            if (!List.IgnoresNormals)
            {
                m_shadows?.Dispose();
                m_shadows = null;
                return;
            }
            m_shadows ??= new MainLightShadows(m_materials.Raster);
            m_shadows.Begin(stream, view, rightEye);
        }

        /// <summary>Records the draws into the view's target, which it sets after its uploads.</summary>
        public void Record(CommandBuffer commands, in RenderView view)
        {
            if (List.Draws.Length == 0)
                return;
            RecordBefore(commands, view);
            PointLayer.SetCameraTarget(commands, view);
            RecordInto(commands, view);
        }

        // Uploads, and points that a layer or a compute shader collects: each makes a GPU that draws in tiles store and load
        // all of a target that is set.
        internal void RecordBefore(CommandBuffer commands, RenderView view)
        {
            if (List.Draws.Length == 0)
                return;
            Adapt(ref view);
            WriteBuffers(commands, view.Style, 1);
            RecordLayer(commands, view);
        }

        // Into whatever target is set, after RecordBefore.
        internal void RecordInto(CommandBuffer commands, RenderView view)
        {
            if (List.Draws.Length == 0)
                return;
            Adapt(ref view);
            if (view.Style.IsShadowed)
                m_shadows.Set(m_layer.Properties, view.EyeOffset);
            if (UsesCompute(view))
                m_layer.Compose(commands, view, m_materials, RasterFor(view));
            else if (view.Style.IsLayered)
                m_layer.End(commands, view, m_materials);
            else
            {
                Set(view);
                DrawBanks(commands, view.Style, false);
            }
        }

        /// <summary>Records the draws for both eyes of a headset into the two slices of the target: at once (each block is two
        /// instances), or one after the other if the style draws through a layer or a compute shader, or vertex shaders cannot
        /// choose a slice. A pipeline that multiplies instances itself multiplies plain draws; the Built-in one has none: 2
        /// would stay and double all that comes later.</summary>
        public void RecordBothEyes(CommandBuffer commands, in RenderView left, in RenderView right, bool pipelineDoublesInstances)
        {
            if (List.Draws.Length == 0)
                return;
            var both = left;
            Adapt(ref both);
            // In instanced single-pass rendering the engine multiplies the instances of plain draws.
            bool isInstanced = !SystemInfo.supportsMultiview;
            if (isInstanced && pipelineDoublesInstances)
                commands.SetInstanceMultiplier(1);
            bool isSinglePass = isInstanced && SystemInfo.supportsRenderTargetArrayIndexFromVertexShader &&
                !both.Style.IsLayered && !UsesCompute(both);
            WriteBuffers(commands, both.Style, isSinglePass ? 2 : 1);
            if (isSinglePass)
            {
                PointLayer.SetCameraTarget(commands, left);
                Set(both);
                m_properties.SetMatrix(ShaderNames.RightViewProjection, right.ViewProjection);
                m_properties.SetVector(ShaderNames.RightForward, right.Forward);
                m_properties.SetVector(ShaderNames.RightEyeOffset, right.EyeOffset);
                DrawBanks(commands, both.Style, true);
            }
            else
            {
                RecordSlice(commands, left, TargetEye.Left);
                RecordSlice(commands, right, TargetEye.Right);
            }
            if (isInstanced && pipelineDoublesInstances)
                commands.SetInstanceMultiplier(2);
        }

        void RecordSlice(CommandBuffer commands, RenderView view, TargetEye eye)
        {
            view.Eye = eye;
            Adapt(ref view);
            RecordLayer(commands, view);
            PointLayer.SetCameraTarget(commands, view);
            RecordInto(commands, view);
        }

        bool UsesCompute(in RenderView view) =>
            view.Style.Shape == PointShape.Pixel && m_raster != null && ComputeRaster.CanDraw(view);

        ComputeRaster RasterFor(in RenderView view) => view.Style.IsProgressive ? m_progressive.Raster : m_raster;

        // What the style is for the list.
        void Adapt(ref RenderView view)
        {
            m_progressive.SkipProgressIfItFits(ref view.Style, List);
            view.Style.IsLit = List.IsLitByDepths;
            view.Style.IsShadowed = List.IsLitByDepths && m_shadows != null && math.csum(view.Light.Color) > 0 &&
                m_shadows.Fit(view.Light.Direction);
        }

        void RecordLayer(CommandBuffer commands, in RenderView view)
        {
            bool usesCompute = UsesCompute(view);
            var chosen = view.Style.IsProgressive ? m_progressive.PointsOf(view.Eye) : null;
            chosen?.Choose(commands, view, List, m_lists, usesCompute ? 0 : VerticesPerBlock(view.Style.Shape));
            if (usesCompute)
                RasterFor(view).Record(commands, view, List, m_lists, m_pool, chosen);
            if (usesCompute || !view.Style.IsLayered)
                return;
            Set(view);
            chosen?.Set(m_properties);
            m_layer.Begin(commands, view);
            DrawBanks(commands, view.Style, false, chosen != null ? ProgressivePass : 0, chosen);
            if (chosen != null)
                m_layer.EndNumbers(commands, view, chosen);
            if (!view.Style.IsBlended)
                return;
            m_layer.BeginBlending(commands, view);
            DrawBanks(commands, view.Style, false, BlendingPass);
        }

        public void Dispose()
        {
            if (!m_drawArguments.IsCreated)
                return;
            List.Dispose();
            m_lists.Dispose();
            m_arguments.Dispose();
            m_raster?.Dispose();
            m_shadows?.Dispose();
            m_progressive.Dispose();
            m_drawArguments.Dispose();
        }

        void Set(in RenderView view)
        {
            var size = view.Style.Size;
            float perGap = size.IsConstant ? 0 : size.Value * view.ScalePx;
            m_lists.Set(m_properties);
            m_properties.SetInteger(ShaderNames.ClipBoxCount, List.ClipBoxes.Length);
            m_properties.SetMatrix(ShaderNames.ViewProjection, view.ViewProjection);
            m_properties.SetVector(ShaderNames.ScreenPx, new Vector4(view.WidthPx, view.HeightPx, 0, 0));
            m_properties.SetVector(ShaderNames.Flip, view.Flip);
            m_properties.SetVector(ShaderNames.Forward, view.Forward);
            m_properties.SetVector(ShaderNames.EyeOffset, view.EyeOffset);
            if (view.Style.Shape == PointShape.Paraboloid || view.Style.IsBlended)
                m_properties.SetVector(ShaderNames.ForwardClip, ForwardClip(view));
            m_properties.SetVector(ShaderNames.Size, new Vector4(size.IsConstant ? size.Value : 0, perGap,
                view.IsOrthographic ? 1 : 0, 0));
            m_properties.SetVector(ShaderNames.SizeLimitsPx, new Vector4(size.LimitsPx.x, size.LimitsPx.y, 0, 0));
            m_properties.SetInteger(ShaderNames.IsOrthographic, view.IsOrthographic ? 1 : 0);
            if (List.IsLitByNormals)
                ShaderValues.SetLight(m_properties, view.Light);
            // A layer's colours become linear when it is composed.
            m_properties.SetInteger(ShaderNames.IsLinear, view.IsLinear && !view.Style.IsLayered ? 1 : 0);
        }

        static Vector4 ForwardClip(in RenderView view) => new Vector4(
            Vector3.Dot(view.ViewProjection.GetRow(2), view.Forward), Vector3.Dot(view.ViewProjection.GetRow(3), view.Forward),
            1 / view.ScalePx, SystemInfo.graphicsUVStartsAtTop ? 0 : 1);

        void DrawBanks(CommandBuffer commands, in PointStyle style, bool isStereo, int pass = 0,
            VisiblePoints chosen = null)
        {
            var material = m_materials.For(style, List.ClipBoxes.Length > 0, List.FiltersPoints, isStereo);
            var topology = style.Shape == PointShape.Pixel ? MeshTopology.Points : MeshTopology.Triangles;
            var arguments = chosen != null ? chosen.Arguments : m_arguments.Buffer;
            for (int i = 0; i < List.Draws.Length; i++)
            {
                var draw = List.Draws[i];
                int at = i * GraphicsBuffer.IndirectDrawIndexedArgs.size;
                m_properties.SetBuffer(ShaderNames.Bank, m_pool.BufferOf(draw.Bank));
                m_properties.SetInteger(ShaderNames.FirstInstance, draw.FirstInstance);
                m_properties.SetInteger(ShaderNames.BankNumber, i);
                if (style.Shape == PointShape.Square)
                    commands.DrawProceduralIndirect(m_materials.SquareIndices, Matrix4x4.identity, material, pass, topology,
                        arguments, at, m_properties);
                else
                    commands.DrawProceduralIndirect(Matrix4x4.identity, material, pass, topology, arguments, at,
                        m_properties);
            }
        }

        // Vertices, or indices: squares have four vertices, other shapes a triangle around them.
        static int VerticesPerBlock(PointShape shape) => PlaneShape.MaxPointsPerBlock *
            (shape == PointShape.Pixel ? 1 : shape == PointShape.Square ? PointMaterials.IndicesOfSquare : 3);

        void WriteBuffers(CommandBuffer commands, in PointStyle style, int eyes)
        {
            m_drawArguments.Clear();
            // Draws without indices read the first four numbers: the others and all starts are 0.
            for (int i = 0; i < List.Draws.Length; i++)
                m_drawArguments.Add(new GraphicsBuffer.IndirectDrawIndexedArgs
                {
                    indexCountPerInstance = (uint)VerticesPerBlock(style.Shape),
                    instanceCount = (uint)(List.Draws[i].InstanceCount * eyes),
                });
            m_arguments.Reserve((long)m_drawArguments.Length * GraphicsBuffer.IndirectDrawIndexedArgs.size);
            m_arguments.Write(commands, m_drawArguments.AsArray());
            m_lists.Write(commands, List);
            if (style.IsShadowed)
                m_shadows.Record(commands, List, m_pool);
        }
    }
}
