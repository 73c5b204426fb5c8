namespace FastPoints.Streaming
{
    // Which views see a cloud; by default all.
    internal struct CloudVisibility
    {
        // A bit; 0 for one that no culling mask hides.
        public uint Layer;

        // The editor's scene culling mask; 0 for any scene.
        public ulong Scenes;

        // By the eye in the editor's hierarchy.
        public bool IsHiddenInSceneViews;

        public bool IsHidden;
    }

    internal struct ViewMask
    {
        // A bit for each layer that the camera's culling mask has not.
        public uint HiddenLayers;
        public ulong Scenes;

        public bool IsSceneView;

        public readonly bool Shows(in CloudVisibility cloud) => !cloud.IsHidden && (cloud.Layer & HiddenLayers) == 0 &&
            (Scenes == 0 || cloud.Scenes == 0 || (Scenes & cloud.Scenes) != 0) && !(IsSceneView && cloud.IsHiddenInSceneViews);
    }
}
