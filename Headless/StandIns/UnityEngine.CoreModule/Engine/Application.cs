using System;

namespace UnityEngine
{
    public sealed class Application
    {
        /// <summary>The host is as an editor that does not play: what is destroyed is destroyed at once.</summary>
        public static bool isPlaying => false;

        public static string streamingAssetsPath => AppContext.BaseDirectory + "StreamingAssets";
    }
}
