using FastPoints.Drawing;
using FastPoints.Streaming;
using Unity.Entities;
using Unity.Mathematics;

namespace FastPoints.Entities
{
    /// <summary>A cloud on disk: an entity with this, its <see cref="PointCloudPathByte"/> and a transform is opened and
    /// streamed, and so is each copy of it. <see cref="PointCloudSystemGroup.ErrorOf"/> says what went wrong.</summary>
    public struct PointCloudFile : IComponentData
    {
        int m_upXorZ; // What differs from Z, so that this is the default.

        /// <summary>Whether <see cref="OriginGeo"/> is the place that the transform moves; otherwise the first shown state
        /// decides.</summary>
        public bool HasOrigin;

        /// <summary>The origin, georeferenced, in CRS units.</summary>
        public double3 OriginGeo;

        /// <summary>Metres of a unit, if the file does not say or is wrong; 0 to use what it says.</summary>
        public double MetresPerUnitOverride;

        /// <summary>What points are coloured by; a cloud without these values chooses another mode. Only what
        /// this and the other fields need is streamed: a change opens the cloud again.</summary>
        public ColorMode Color;
        public ColorRamp ColorRamp;

        /// <summary>Classes whose points are not drawn.</summary>
        public ClassMask HiddenClasses;

        /// <summary>How much of its colours is lit, from 0 to 1: see <see cref="CloudLook.Light"/>.</summary>
        public float Light;

        /// <summary>Set it if there may be newer data on disk: it is opened, and the shown cloud stays until it is ready. It
        /// resets to false.</summary>
        public bool NeedsRefresh;

        /// <summary>The cloud's axis that points up: Z, if it is not set.</summary>
        public UpAxis Up
        {
            readonly get => (UpAxis)(m_upXorZ ^ (int)UpAxis.Z);
            set => m_upXorZ = (int)value ^ (int)UpAxis.Z;
        }

        internal readonly CloudUnits Units(CloudUnits ofCloud) =>
            MetresPerUnitOverride > 0 ? new CloudUnits(MetresPerUnitOverride) : ofCloud;

        internal readonly UnityLocalSpace SpaceOf(BoundsGeo boundsGeo, CloudUnits ofCloud)
        {
            var space = UnityLocalSpace.Of(boundsGeo, Units(ofCloud), Up);
            if (HasOrigin)
                space.OriginGeo = OriginGeo;
            return space;
        }

        /// <summary>Whether all but paths, light and place, by which a cloud is opened, is the same.</summary>
        internal readonly bool HasSameOpenSettings(in PointCloudFile other) =>
            Color == other.Color && ColorRamp == other.ColorRamp && HiddenClasses.Equals(other.HiddenClasses) &&
            Up == other.Up && MetresPerUnitOverride.Equals(other.MetresPerUnitOverride) && (other.HasOrigin || !HasOrigin);
    }
}
