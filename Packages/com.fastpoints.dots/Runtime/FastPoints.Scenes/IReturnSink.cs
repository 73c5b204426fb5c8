using Unity.Collections;

namespace FastPoints.Scenes
{
    /// <summary>Where the returns of a scan go. Called on the main thread; what it gets is valid only during the call.</summary>
    public interface IReturnSink
    {
        void Append(NativeArray<ScanReturn> returns);

        /// <param name="returns">All returns.</param>
        /// <param name="returnOfPlace">Which of them come next, in this order.</param>
        void Append(NativeArray<ScanReturn> returns, NativeArray<int> returnOfPlace);
    }
}
