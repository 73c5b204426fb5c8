using Unity.IO.LowLevel.Unsafe;

namespace FastPoints.Reading
{
    /// <summary>A file that is opened when something is first read from it. Threads of the pool open readers, but handles belong
    /// to the main thread.</summary>
    sealed class SourceHandle
    {
        FileHandle m_handle;
        bool m_isOpen;

        public SourceHandle(string path) => Path = path;

        /// <summary>As the caller gave it, for messages.</summary>
        public string Path { get; }

        public ref readonly FileHandle Open()
        {
            if (!m_isOpen)
                m_handle = AsyncReadManager.OpenFileAsync(System.IO.Path.GetFullPath(Path));
            m_isOpen = true;
            return ref m_handle;
        }

        /// <summary>Closes the file until the next read.</summary>
        public void Close()
        {
            if (m_isOpen)
                m_handle.Close().Complete();
            m_isOpen = false;
        }
    }
}
