using System.Collections.Generic;
using FastPoints.Build;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;

namespace FastPoints.Picture
{
    /// <summary>Draws a picture of a converted cloud within a point budget: the top of the octree determines camera,
    /// colours and size, then the nodes that the camera needs most are drawn.</summary>
    public sealed class DrawConvertedCloud
    {
        public const long DefaultBudget = 2000000;

        /// <summary>Points that the choices are made from.</summary>
        public const int PointsToPlanWith = 200000;

        readonly CloudFolder m_folder;
        readonly PictureOptions m_options;
        readonly long m_budget;

        /// <param name="budget">The most points to draw; 0 for <see cref="DefaultBudget"/>.</param>
        public DrawConvertedCloud(CloudFolder folder, PictureOptions options, long budget = 0)
        {
            m_folder = folder;
            m_options = options;
            m_budget = budget > 0 ? budget : DefaultBudget;
        }

        /// <summary>Camera and colours follow from the manifest, without examining points: nothing occupies the main thread for
        /// long. Degrees are drawn as they are; without ranges to show, outliers make the rest small.</summary>
        public bool PlansByManifest { get; set; }

        /// <summary>Points that were drawn, including those outside the picture.</summary>
        public long PointsDrawn { get; private set; }
        public int NodesDrawn { get; private set; }
        internal PicturePlan Plan { get; private set; }

        /// <summary>Why the cloud's edits are not drawn; null if they are, or if it has none.</summary>
        public PointCloudException Refused { get; private set; }

        /// <summary>Null until the work has ended.</summary>
        public RgbaImage Image { get; private set; }

        /// <summary>Coroutine, with the stages <c>select</c> and <c>draw</c>. Throws if the cloud cannot be read.</summary>
        public IEnumerator<JobStep> Run(StageProgress progress)
        {
            progress?.Begin("select");
            var schema = LoadNodes.SchemaFor(m_folder, m_options.AttributesToMeasure());
            var transform = m_folder.Manifest.Grid.TransformFromCorner(m_folder.Manifest.Root.Corner);
            var ranges = PlansByManifest ? DisplayRanges.Of(m_folder.Manifest)
                : m_options.NewRanges(m_folder.Manifest.Crs.Units);
            using (var selection = new NodeSelection(m_folder))
            {
                yield return JobStep.Of(PoolTask.Run(m_folder.FolderPath, () => (EditPlan.Of(m_folder, out var e), e),
                    read => (selection.Edits, Refused) = read));
                if (!PlansByManifest)
                    yield return JobStep.Of(ConvertCloud.MeasureRanges(m_folder, selection, schema, m_options.UpAxis, ranges,
                        points => selection.Load(points, null)));
                Plan = new PicturePlan(m_options, ranges, transform);
                if (Plan.LitLevel > 0 && !m_options.Shadows)
                    schema = LoadNodes.WithNormals(schema, m_folder);

                var view = Plan.Camera.ToStreamView(m_options.WidthPx * m_options.SamplesPerEdge,
                    m_options.HeightPx * m_options.SamplesPerEdge);
                using var canvas = new PictureCanvas(m_options.WidthPx, m_options.HeightPx, Allocator.Persistent,
                    m_options.SamplesPerEdge);
                canvas.UseShadows(Plan.ShadowFrameOfPicture());
                selection.Choose(view, m_budget,
                    canvas.Shadows == null ? (StreamView?)null : canvas.ShadowMapProjection.ViewFor(view));
                using var batch = new PointBatch(schema, selection.PointCountOrThrow, Allocator.Persistent);
                yield return JobStep.Of(selection.Load(batch, progress));
                NodesDrawn = selection.NodeCount;
                PointsDrawn = batch.Count;
                progress?.Begin("draw");
                yield return JobStep.Of(SamplePicture.ChooseSize(canvas, batch, Plan, batch.Count));
                yield return JobStep.Of(SamplePicture.DrawAndResolve(canvas, batch, Plan, progress));
                Image = canvas.ToImage();
            }
            progress?.End();
        }
    }
}
