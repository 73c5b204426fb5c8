namespace FastPoints.Streaming
{
    /// <summary>Which views see a cloud. The default is seen by all.</summary>
    internal struct CloudVisibility
    {
        /// <summary>The bit of its layer; 0 for one that no culling mask hides.</summary>
        public uint Layer;

        /// <summary>The editor's scene culling mask; 0 for any scene.</summary>
        public ulong Scenes;

        /// <summary>Whether the eye in the hierarchy hides it from scene views.</summary>
        public bool IsHiddenInSceneViews;

        public bool IsHidden;
    }

    /// <summary>Which clouds a view sees. The default sees all.</summary>
    internal struct ViewMask
    {
        /// <summary>A bit for each layer that the camera's culling mask has not.</summary>
        public uint HiddenLayers;

        /// <summary>The editor's scene culling mask; 0 for any scene.</summary>
        public ulong Scenes;

        public bool IsSceneView;

        public readonly bool Shows(in CloudVisibility cloud) => !cloud.IsHidden && (cloud.Layer & HiddenLayers) == 0 &&
            (Scenes == 0 || cloud.Scenes == 0 || (Scenes & cloud.Scenes) != 0) && !(IsSceneView && cloud.IsHiddenInSceneViews);
    }
}
