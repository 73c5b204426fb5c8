using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>What is known of a slot of the cache: the entity of the node that lies there.</summary>
    public struct TrackedSlot
    {
        public const byte IsResident = 1;
        public const byte IsDrawn = 2;

        /// <summary>Null where there is none.</summary>
        public Entity Entity;
        public int Version;

        /// <summary>What the entity says.</summary>
        public byte State;
    }
}
