using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Picture;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    internal sealed unsafe class StreamedBlocks : IDisposable
    {
        readonly MemoryNodePool m_pool;
        readonly int m_cloud;
        readonly PointBatch m_block;
        readonly PointColumn m_classes;
        NativeList<LocalClip> m_clips;
        NativeArray<StoredColumn> m_columns;
        NativeArray<PointColumn> m_targets;

        internal StreamedBlocks(StreamContext stream, int cloud, PicturePlan plan)
        {
            Stream = stream;
            m_pool = stream.Pool as MemoryNodePool ?? throw new ArgumentException(
                "wanted a pool in ordinary memory, got " + stream.Pool.GetType().Name, nameof(stream));
            m_cloud = cloud;
            Plan = plan;
            var layout = stream.Clouds[cloud].Source.Layout;
            var attributes = new List<PointAttribute>(PositionColumns.Attributes(AttributeType.Float64));
            var columns = new List<StoredColumn>();
            foreach (int plane in stream.Clouds[cloud].Source.Planes)
            {
                var of = layout.Planes[plane];
                for (int c = of.FirstColumn; plane != StoreLayout.PositionPlane && c < of.FirstColumn + of.ColumnCount; c++)
                {
                    columns.Add(layout.Columns[c]);
                    attributes.Add(new PointAttribute(layout.NameOfColumn(of, c), layout.Columns[c].Type));
                }
            }
            m_block = new PointBatch(new PointSchema(attributes), PlaneShape.MaxPointsPerBlock, Allocator.Persistent);
            if (m_block.Bytes.Length > DrawBlocksJob.MaxBatchBytes)
                throw new ArgumentException("planes of " + m_block.Bytes.Length + " bytes a block, wanted at most " +
                    DrawBlocksJob.MaxBatchBytes, nameof(cloud));
            m_columns = new NativeArray<StoredColumn>(columns.ToArray(), Allocator.Persistent);
            m_targets = new NativeArray<PointColumn>(columns.Count, Allocator.Persistent);
            for (int c = 0; c < columns.Count; c++)
                m_targets[c] = m_block.Column(3 + c);
            if (!plan.HiddenClasses.IsEmpty && m_block.Schema.Has(AttributeNames.Classification))
            {
                HiddenClasses = plan.HiddenClasses;
                m_classes = m_block.Column(m_block.Schema.IndexOf(AttributeNames.Classification));
            }
            m_clips = new NativeList<LocalClip>(Allocator.Persistent);
        }

        public StreamContext Stream { get; }
        public PicturePlan Plan { get; }

        /// <summary>Classes whose points are not drawn; the source must stream the classification.</summary>
        public ClassMask HiddenClasses { get; }

        internal PointDrawing DrawingFor(in Camera camera, PictureCanvas canvas)
        {
            var cloud = Stream.Clouds[m_cloud];
            var drawing = Plan.DrawingOf(m_block, canvas);
            var linear = cloud.Placement.Linear;
            var step = cloud.Source.Grid.Step;
            drawing.Projection = new PointProjection(camera, PositionTransform.Identity, canvas.WidthPx, canvas.HeightPx)
            {
                X = Turned(camera, linear.c0) * step.x,
                Y = Turned(camera, linear.c1) * step.y,
                Z = Turned(camera, linear.c2) * step.z,
                W = camera.ToView(cloud.Placement.OriginWorld),
            };
            var source = cloud.Source;
            var toWorld = DrawListCloud.NormalsToWorld(linear,
                source.Crs.Units.MetresAt(source.Grid.ToGeo(source.Root.Corner), UpAxis.Z));
            drawing.Normals.Light = Plan.Light.RelativeTo(camera.EyeGeo);
            drawing.Normals.ToLight = toWorld;
            drawing.Normals.ViewToLight = new double3x3(camera.Right, camera.Up, camera.Forward);
            drawing.Normals.ToView = new double3x3(Turned(camera, toWorld.c0), Turned(camera, toWorld.c1),
                Turned(camera, toWorld.c2));
            return drawing;
        }

        internal void Collect(SizeTree sizes, DrawnBlocks to)
        {
            var cloud = Stream.Clouds[m_cloud];
            var cubes = cloud.Source.Cubes;
            var step = cloud.Source.Grid.Step;
            to.Clear(sizes.Nodes);
            for (int i = 0; i < Stream.Drawn.Length; i++)
            {
                var drawn = Stream.Drawn[i];
                if (drawn.Cloud != m_cloud)
                    continue;
                var address = cloud.Pages[drawn.Page].Addresses[drawn.Node];
                var inCube = cubes.PositionInCube(cloud.Pages + drawn.Page, drawn.Node);
                byte* at = m_pool.AddressOf(drawn.Range);
                int blocks = cloud.Pages[drawn.Page].Nodes[drawn.Node].BlockCount;
                to.Nodes.Add(new NodeBlocks
                {
                    Corner = address.Corner,
                    BlockCount = blocks,
                    FadeBits = PointFade.BitsOf(drawn),
                    SizeNode = sizes.Nodes.Length > 0 ? sizes.NodeOfDrawn[i] : 0,
                    CubeCorner = cubes.CornerAt(inCube, address.Level) / step,
                    CubesPerStep = step / cubes.SizeAt(address.Level),
                });
                for (int p = 0; p < cloud.Source.Planes.Length; p++)
                {
                    long bytes = cloud.RangeOf(drawn.Page, drawn.Node, p).LengthBytes;
                    to.Add(new PlaneView(at, cloud.ShapeOf(drawn.Page, drawn.Node, p), blocks), bytes);
                    at += bytes;
                }
            }
        }

        // isPixels: whatever size the points have. sums: of a picture whose points are blended with it.
        internal JobHandle ScheduleDraw(DrawnBlocks drawn, in Camera camera, PictureCanvas canvas, bool isPixels = false,
            NativeArray<ulong> sums = default)
        {
            var cloud = Stream.Clouds[m_cloud];
            var drawing = DrawingFor(camera, canvas);
            if (isPixels)
                (drawing.IsWorldSize, drawing.MaxTileSizePx) = (false, 1);
            else if (drawn.SizeNodes.Length > 0)
            {
                drawing.IsWorldSize = true;
                drawing.MaxTileSizePx = drawing.Size.MaxPx;
            }
            m_clips.Clear();
            foreach (var box in Stream.ClipBoxes)
                m_clips.Add(InSteps(new LocalClip(box, cloud.Placement), cloud.Source.Grid.Step));
            return new DrawBlocksJob
            {
                Nodes = drawn.Nodes.AsArray(),
                Planes = drawn.Planes.AsArray(),
                PlaneCount = cloud.Source.Planes.Length,
                Columns = m_columns,
                Targets = m_targets,
                Palettes = canvas.Palettes,
                SizeOfTile = canvas.SizeOfTile,
                SizeNodes = drawn.SizeNodes,
                Clips = m_clips.AsArray(),
                Classes = m_classes,
                HiddenClasses = HiddenClasses,
                Drawing = drawing,
                Pixels = canvas.Pixels,
                Sums = sums,
            }.ScheduleParallel(drawn.Nodes.Length, 1, default);
        }

        public void Dispose()
        {
            if (!m_clips.IsCreated)
                return;
            m_block.Dispose();
            m_clips.Dispose();
            m_columns.Dispose();
            m_targets.Dispose();
        }

        static LocalClip InSteps(LocalClip clip, double3 step)
        {
            clip.ToBox = new double3x3(clip.ToBox.c0 * step.x, clip.ToBox.c1 * step.y, clip.ToBox.c2 * step.z);
            return clip;
        }

        static double3 Turned(in Camera camera, double3 world) =>
            new double3(math.dot(world, camera.Right), math.dot(world, camera.Up), math.dot(world, camera.Forward));
    }
}
