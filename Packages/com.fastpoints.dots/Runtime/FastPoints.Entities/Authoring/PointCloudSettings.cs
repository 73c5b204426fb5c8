using FastPoints.Drawing;
using FastPoints.Rendering;
using FastPoints.Streaming;
using Unity.Entities;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Serialization;

namespace FastPoints.Entities
{
    /// <summary>Limits and look of all clouds of the world; there is at most one of these at a time.</summary>
    [ExecuteAlways]
    [DisallowMultipleComponent]
    [AddComponentMenu("FastPoints/Point Cloud Settings")]
    [HelpPage("settings")]
    [Icon("Packages/com.fastpoints.dots/Editor/Icons/PointCloud.png")]
    public sealed class PointCloudSettings : MonoBehaviour
    {
        [Range(0.1f, 100)]
        [Tooltip("Points that are drawn at most, in millions: of all clouds and cameras together.")]
        public float MillionPoints = 2;

        [Range(64, 16384)]
        [Tooltip("Graphics memory of points at most, in MiB.")]
        [FormerlySerializedAs("MemoryMiB")]
        public int MemoryMebibytes = 512;

        [Range(1, 64)]
        [Tooltip("Copied into graphics memory in one frame at most, in MiB.")]
        [FormerlySerializedAs("UploadMiBPerFrame")]
        public int UploadMebibytesPerFrame = 4;

        [Range(0, 64)]
        [Tooltip("Nodes smaller than this on the screen, in pixels, are left out.")]
        public float MinNodePx = 1;

        [Range(0, 1)]
        [Tooltip("How long detail takes to appear or to leave, point by point. 0 for at once.")]
        public float FadeSeconds = StreamSettings.SceneFadeSeconds;

        public PointShape Shape = PointShape.Square;

        [Tooltip("Pixels: the same near and far. World: a length, smaller farther away. Adaptive: as far apart as points are, " +
            "so that surfaces close.")]
        public PointSizeMode SizeMode = PointSizeMode.Pixels;

        [Min(0)]
        [Tooltip("Edge of a point's square, diameter of its disc: in pixels, world units, or (adaptive) distances of points.")]
        public float Size = 2;

        [Range(1, 64)]
        [Tooltip("No point is larger, in pixels.")]
        public float MaxSizePx = PointSize.DefaultMaxPx;

        [Range(0, 2)]
        [Tooltip("Eye-dome lighting: shades points by how far their neighbours lie before them. 0 for none, 0.25 is usual.")]
        public float EyeDomeLighting;

        [Tooltip("Fills single pixels that points leave open in a surface.")]
        public bool FillHoles;

        [Tooltip("Points that are lit shade each other from the main light.")]
        public bool Shadows;

        [Range(0, 100)]
        [Tooltip("A picture of more points, in millions, is drawn over several frames, the visible points in each. 0: all at " +
            "once, as splats always are.")]
        public float MillionPointsPerFrame;

        [Range(0, 100)]
        [Tooltip("Milliseconds that the GPU may take for a frame: the number above is where it begins. 0: it stays. Takes " +
            "Frame Timing Stats of the player settings.")]
        public float GpuMilliseconds;

        /// <summary>How points look.</summary>
        public PointStyle Style => new PointStyle
        {
            Shape = Shape,
            Size = new PointSize { Mode = SizeMode, Value = Size, MinPx = 1, MaxPx = MaxSizePx },
            EdlStrength = EyeDomeLighting,
            FillsHoles = FillHoles,
            Shadows = Shadows,
            PointsPerFrame = (int)math.round(MillionPointsPerFrame * 1e6),
            GpuFrameMs = GpuMilliseconds,
        };

        internal PointCloudBudget Budget => new PointCloudBudget
        {
            Points = (long)math.round(MillionPoints * 1e6),
            PoolBytes = (long)MemoryMebibytes << 20,
            MaxUploadBytesPerFrame = UploadMebibytesPerFrame << 20,
            MinNodePx = MinNodePx,
            FadeSeconds = FadeSeconds,
        };

        OwnedEntity m_entity;

        void Reset() => MemoryMebibytes = (int)(PointCloudSystemGroup.DefaultPoolBytes >> 20);

        void OnEnable() => Update();

        void OnDisable() => m_entity.Destroy();

        void Update()
        {
            if (!m_entity.TryGet(out var entities))
            {
                if (!m_entity.TryCreate(out entities))
                    return;
                entities.AddComponentData(m_entity.Value, new PointCloudBudget());
                entities.AddComponentData(m_entity.Value, new PointCloudStyle());
            }
            entities.SetComponentData(m_entity.Value, Budget);
            entities.SetComponentData(m_entity.Value, new PointCloudStyle { Value = Style });
        }
    }

    /// <summary>For subscenes. An open one has both entities, with equal values.</summary>
    internal sealed class SettingsBaker : Baker<PointCloudSettings>
    {
        public override void Bake(PointCloudSettings authoring)
        {
            var entity = GetEntity(TransformUsageFlags.None);
            AddComponent(entity, authoring.Budget);
            AddComponent(entity, new PointCloudStyle { Value = authoring.Style });
        }
    }
}
